//! Chores of the repository: `cargo xtask test` runs everything that CI runs, `cargo xtask verify`
//! also the tests that take minutes; `cargo xtask --help` lists the others.

mod book;
mod changes;
mod command;
mod crates;
mod cycles;
mod dependencies;
mod equations;
mod language;
mod outcome;
mod pages;
mod python;
mod shown;
mod verification;
mod workflows;

use std::{env, process::ExitCode, time::Instant};

use command::{WORKSPACE, cargo, program, run, run_counted, with};
use outcome::{Count, Failure, Finding};

const USAGE: &str = "\
usage: cargo xtask test [--keep-going] [JOB | STEP]...
                             run everything that CI runs, or the steps of these jobs or with these
                             titles; with --keep-going continue after steps that fail
       cargo xtask cycles    list the circles between files
       cargo xtask verify    run all tests, including those that take minutes, and write the
                             book's table of them
       cargo xtask fuzz [SECONDS | --inputs N] [--seed S] [READER...]
                             read damaged inputs with every reader [default: for an hour]
       cargo xtask dependencies --write
                             write the dependencies of crates and pages into the book
       cargo xtask architecture
                             draw the crates and their dependencies for ARCHITECTURE.md
       cargo xtask book      build the book into target/book, with the app of target/playground
                             if it exists
       cargo xtask site      build that app, and the book with it
       cargo xtask equations --write
                             convert the book's equations for the documentation of the code
       cargo xtask playground
                             build the app that runs in a browser alone, in target/playground
       cargo xtask packages
                             pack the published crates and build each from its package
       cargo xtask paper     write the paper to target/paper/paper.pdf
       cargo xtask shown [--all]
                             run the commands in the README and the book's first pages, with
                             --all also those that take minutes
       cargo xtask workflows check the workflows in .github";

/// Option with which a failed step does not end the others.
const KEEP_GOING: &str = "--keep-going";

/// A step with its job, in which CI runs it beside the others, and its title.
type Step = (&'static str, &'static str, fn() -> Result<Finding, Failure>);

/// Cheap steps first, so that an error is reported early.
const TEST: &[Step] = &[
    ("sources", "Formatting", formatting),
    ("sources", "Circles between files", cycles::check),
    ("sources", "Table of changes", changes::check_table),
    ("sources", "Table of accuracy", accuracy),
    ("sources", "Table of dependencies", dependencies::check_table),
    ("sources", "Picture of the crates", crates::check_picture),
    ("sources", "Packages", crates::check_packages),
    ("sources", "Language", language::check),
    ("sources", "Features of the Python package", crates::check_features),
    ("sources", "Equations of the documentation", equations::check),
    ("sources", "Workflows", workflows),
    ("pages", "Bundle of the report", pages::report_bundle),
    ("pages", "Bundle of the app", pages::app_bundle),
    ("lints", "Lints", lints),
    ("tests", "Tests", verification::tests),
    ("tests", "Table of verification", verification::check_table),
    ("tests", "Damaged inputs", damaged_inputs),
    ("tests", "Documentation examples", doc_tests),
    ("lints", "Documentation", documentation),
    ("book", "Book", book::build),
    ("book", "Paper", python::paper),
    ("book", "Commands of the first pages", shown::quick),
    ("pages", "Core for the browser", pages::core),
    ("python", "Python example", python::example),
    ("python", "Python package", python::package),
    ("pages", "Report in a browser", pages::report),
    ("pages", "App in a browser", pages::app),
    ("pages", "App in a browser alone", pages::alone),
];

const VERIFY: &[Step] = &[
    ("verify", "All tests", verification::all_tests),
    ("verify", "Table of verification", verification::write_table),
    ("verify", "Commands of the first pages", shown::all),
];

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args().skip(1).collect();
    let chore = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["test", ref options @ ..] => return test(options),
        ["verify"] => return take(VERIFY, false),
        ["cycles"] => cycles::check(),
        ["book"] => book::build(),
        ["site"] => pages::playground().and_then(|_| book::build()),
        ["equations", "--write"] => equations::write(),
        ["equations", ref arguments @ ..] => equations::preprocess(arguments),
        ["paper"] => python::paper(),
        ["packages"] => crates::package(),
        ["shown"] => shown::quick(),
        ["shown", "--all"] => shown::all(),
        ["workflows"] => workflows(),
        ["architecture"] => crates::draw(),
        ["dependencies", "--write"] => dependencies::write_table(),
        ["playground"] => pages::playground(),
        ["fuzz"] => fuzz(&["3600"]),
        ["fuzz", ref options @ ..] => fuzz(options),
        ["--help" | "-h"] => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match chore {
        Ok(Finding::Skipped(reason)) => println!("skipped, {reason}"),
        Ok(_) => {}
        Err(failure) => {
            eprintln!("{}", failure.reason);
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

/// Runs all steps, or those of the given jobs and titles; continues after a failed one on request.
fn test(options: &[&str]) -> ExitCode {
    let (switches, names): (Vec<_>, Vec<_>) =
        options.iter().copied().partition(|option| *option == KEEP_GOING);
    let is_named = |step: &Step, name: &str| step.0 == name || step.1 == name;
    if let Some(unknown) = names.iter().find(|name| !TEST.iter().any(|step| is_named(step, name))) {
        eprintln!("`{unknown}` is neither a job nor a step; these are:");
        TEST.iter().for_each(|(job, title, _)| eprintln!("  {job}: {title}"));
        return ExitCode::from(2);
    }
    let is_chosen =
        |step: &&Step| names.is_empty() || names.iter().any(|name| is_named(step, name));
    let chosen: Vec<_> = TEST.iter().filter(is_chosen).copied().collect();
    take(&chosen, !switches.is_empty())
}

fn take(steps: &[Step], keep_going: bool) -> ExitCode {
    let start = Instant::now();
    let mut total = Count::default();
    let mut failed = Vec::new();
    for (number, (_, title, step)) in steps.iter().enumerate() {
        println!("[{}/{}] {title}", number + 1, steps.len());
        let begin = Instant::now();
        let outcome = step();
        let seconds = begin.elapsed().as_secs_f64();
        match outcome {
            Ok(Finding::Done) => println!("      {title}: done in {seconds:.1} s"),
            Ok(Finding::Skipped(reason)) => println!("      {title}: skipped, {reason}"),
            Ok(Finding::Tested(count)) => {
                println!("      {title}: {count} in {seconds:.1} s");
                total += count;
            }
            Err(failure) => {
                total += failure.count;
                eprintln!("\n{title} failed: {}", failure.reason);
                failed.push(*title);
                if !keep_going {
                    break;
                }
            }
        }
    }
    match failed.is_empty() {
        true => println!("\nAll steps in {:.0} s\n{total}", start.elapsed().as_secs_f64()),
        false => println!("\nFailed: {}\n{total}", failed.join(", ")),
    }
    if failed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn formatting() -> Result<Finding, Failure> {
    run(cargo().args(["fmt", "--all", "--check"]), "run `cargo fmt --all`").map(Finding::from)
}

fn lints() -> Result<Finding, Failure> {
    // The command without its app as well.
    let all = [&WORKSPACE[..], &["--workspace"]];
    for (packages, targets) in all.into_iter().zip(["--all-targets", "--bin=wholestring"]) {
        let mut clippy = cargo();
        clippy.arg("clippy").args(packages).args([targets, "--", "-D", "warnings"]);
        run(&mut clippy, "warnings count as errors")?;
    }
    Ok(Finding::Done)
}

fn workflows() -> Result<Finding, Failure> {
    workflows::check(USAGE, &TEST.iter().map(|step| step.0).collect())
}

/// The book's table of the errors of each mesh has the rows and columns that would be measured.
fn accuracy() -> Result<Finding, Failure> {
    with(python::python("3.11"), |mut python| {
        run(python.args(["scripts/accuracy.py", "--check"]), "the table is out of date")
    })
}

/// Runs every reader on damaged inputs, with the fuzzer's options. Unoptimised arithmetic checks
/// remain enabled.
fn fuzz(fuzz_options: &[&str]) -> Result<Finding, Failure> {
    let advice = "a reader failed on an input: fix it, and add the input as a test";
    run(program("--bin", "wholestring-fuzz")?.args(fuzz_options), advice).map(Finding::from)
}

fn damaged_inputs() -> Result<Finding, Failure> {
    fuzz(&["20"])
}

fn doc_tests() -> Result<Finding, Failure> {
    run_counted(cargo().arg("test").args(WORKSPACE).args(["--doc", "--no-fail-fast"]))
        .map(Finding::Tested)
}

fn documentation() -> Result<Finding, Failure> {
    let mut doc = cargo();
    doc.arg("doc").args(WORKSPACE).arg("--no-deps").env("RUSTDOCFLAGS", "-D warnings");
    run(&mut doc, "warnings count as errors").map(Finding::from)
}
