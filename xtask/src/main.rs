//! Chores of the repository: `cargo xtask test` runs everything that CI runs, `cargo xtask verify`
//! also runs the tests that take minutes, `cargo xtask changes` tests the examples of changes,
//! `cargo xtask fuzz` reads damaged inputs for a given time, `cargo xtask peers` compares the speed
//! with other programs, `cargo xtask accuracy` measures the errors of the mesh accuracies,
//! `cargo xtask playground` builds the app that runs in a browser alone, `cargo xtask portability`
//! tests other systems and processors.

mod accuracy;
mod app;
mod architecture;
mod book;
mod changes;
mod clean_root;
mod command;
mod count;
mod cycles;
mod dependencies;
mod features;
mod finding;
mod folders;
mod language;
mod metadata;
mod packages;
mod page;
mod paper;
mod peers;
mod portability;
mod python;
mod python_package;
mod shown;
mod site;
mod usage;
mod verification;
mod wasm;
mod web;
mod winget;
mod workflows;

use std::{env, process::ExitCode, time::Instant};

use command::{Failure, WORKSPACE, cargo, program, run, run_counted, succeeds};
use count::Count;
use finding::Finding;
use folders::root;
use usage::USAGE;

/// Option with which a failed step does not end the others.
const KEEP_GOING: &str = "--keep-going";

type Step = (&'static str, fn() -> Result<Finding, Failure>);

/// Cheap steps first, so that an error is reported early.
const TEST: &[Step] = &[
    ("Formatting", formatting),
    ("Circles between files", no_cycles),
    ("Table of changes", changes::check_table),
    ("Table of accuracy", accuracy::check_table),
    ("Table of dependencies", dependencies::check_table),
    ("Picture of the crates", architecture::check),
    ("Packages", packages::check),
    ("Language", language::check),
    ("Features of the Python package", features::check),
    ("Equations of the documentation", site::check_equations),
    ("Workflows", workflows::check),
    ("Bundle of the report", page::bundle),
    ("Bundle of the app", app::bundle),
    ("Lints", lints),
    ("Tests", tests),
    ("Table of verification", verification::check_table),
    ("Damaged inputs", damaged_inputs),
    ("Documentation examples", doc_tests),
    ("Documentation", documentation),
    ("Book", site::build),
    ("Paper", paper::build),
    ("Commands of the first pages", shown::quick),
    ("Core for the browser", wasm::core),
    ("Python example", python::example),
    ("Python package", python_package::package),
    ("Report in a browser", page::browser),
    ("App in a browser", app::browser),
    ("App in a browser alone", wasm::browser),
];

const VERIFY: &[Step] = &[
    ("All tests", verification::all_tests),
    ("Table of verification", verification::write_table),
    ("Commands of the first pages", shown::all),
];

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["test", ref options @ ..] => test(options),
        ["verify"] => take(VERIFY, false),
        ["cycles"] => exit_code(no_cycles()),
        ["changes"] => exit_code(changes::try_out(None, false)),
        ["changes", "--tests"] => exit_code(changes::try_out(None, true)),
        ["changes", "--only", name] => exit_code(changes::try_out(Some(name), false)),
        ["changes", "--only", name, "--tests"] | ["changes", "--tests", "--only", name] => {
            exit_code(changes::try_out(Some(name), true))
        }
        ["changes", "--record", name] => exit_code(changes::record(name)),
        ["peers"] => exit_code(peers::side_by_side(false)),
        ["peers", "--write"] => exit_code(peers::side_by_side(true)),
        ["book"] => exit_code(site::build()),
        ["site"] => exit_code(wasm::playground().and_then(|_| site::build())),
        ["bundles"] => exit_code(page::bundle().and_then(|_| app::bundle())),
        ["equations", "--write"] => exit_code(site::write_equations()),
        ["equations", ref arguments @ ..] => exit_code(site::equations(arguments)),
        ["paper"] => exit_code(paper::build()),
        ["packages"] => exit_code(packages::try_all()),
        ["shown"] => exit_code(shown::quick()),
        ["shown", "--all"] => exit_code(shown::all()),
        ["clean-root", ref suites @ ..] => exit_code(clean_root::try_all(suites)),
        ["winget", sha256] => exit_code(winget::write(sha256)),
        ["portability", ref systems @ ..] => exit_code(portability::try_out(systems)),
        ["workflows"] => exit_code(workflows::check()),
        ["architecture"] => exit_code(architecture::write()),
        ["dependencies", "--write"] => exit_code(dependencies::write_table()),
        ["accuracy", "--write"] => exit_code(accuracy::measure(true, &[])),
        ["accuracy", ref words @ ..] => exit_code(accuracy::measure(false, words)),
        ["playground"] => exit_code(wasm::playground()),
        ["fuzz"] => exit_code(fuzz(&["3600"])),
        ["fuzz", ref fuzz_options @ ..] => exit_code(fuzz(fuzz_options)),
        ["--help" | "-h"] => {
            println!("{USAGE}");
            ExitCode::SUCCESS
        }
        _ => {
            eprintln!("{USAGE}");
            ExitCode::from(2)
        }
    }
}

/// Runs all steps, or those with the given titles; continues after a failed one on request.
fn test(options: &[&str]) -> ExitCode {
    let (switches, titles): (Vec<_>, Vec<_>) =
        options.iter().partition(|option| **option == KEEP_GOING);
    if let Some(unknown) = titles.iter().find(|title| !TEST.iter().any(|step| step.0 == **title)) {
        eprintln!("`{unknown}` is not a step; the steps are:");
        TEST.iter().for_each(|step| eprintln!("  {}", step.0));
        return ExitCode::from(2);
    }
    let chosen: Vec<_> =
        TEST.iter().filter(|step| titles.is_empty() || titles.contains(&step.0)).copied().collect();
    take(&chosen, !switches.is_empty())
}

fn take(steps: &[Step], keep_going: bool) -> ExitCode {
    let start = Instant::now();
    let mut total = Count::default();
    let mut failed = Vec::new();
    for (number, (title, step)) in steps.iter().enumerate() {
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
    if !failed.is_empty() {
        println!("\nFailed: {}", failed.join(", "));
        println!("{total}");
        return ExitCode::FAILURE;
    }
    println!("\nAll steps in {:.0} s", start.elapsed().as_secs_f64());
    println!("{total}");
    ExitCode::SUCCESS
}

fn formatting() -> Result<Finding, Failure> {
    run(cargo().args(["fmt", "--all", "--check"]), "run `cargo fmt --all`")?;
    Ok(Finding::Done)
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

fn tests() -> Result<Finding, Failure> {
    // nextest runs the tests of all crates in parallel, but not the documentation examples.
    let mut runner = cargo();
    if succeeds(cargo().args(["nextest", "--version"])) {
        runner.args(["nextest", "run", "--no-fail-fast"]).args(WORKSPACE);
    } else {
        runner.args(["test", "--no-fail-fast"]).args(WORKSPACE);
        runner.args(["--lib", "--bins", "--tests", "--examples"]);
    }
    verification::forget()?;
    runner.env(wholestring_verification::FILE, verification::reported());
    run_counted(&mut runner).map(Finding::Tested)
}

/// No file uses another that, through others, uses it.
fn no_cycles() -> Result<Finding, Failure> {
    let found = cycles::in_words(&root()).map_err(|error| Failure::new(error.to_string()))?;
    if found.is_empty() {
        return Ok(Finding::Done);
    }
    Err(Failure::new(format!(
        "{found}files use each other in circles: move the shared items to a separate file"
    )))
}

/// Runs every reader on damaged inputs, with the fuzzer's options. Unoptimised arithmetic checks
/// remain enabled.
fn fuzz(fuzz_options: &[&str]) -> Result<Finding, Failure> {
    run(
        program("--bin", "wholestring-fuzz")?.args(fuzz_options),
        "a reader failed on an input: fix it, and add the input as a test",
    )?;
    Ok(Finding::Done)
}

fn damaged_inputs() -> Result<Finding, Failure> {
    fuzz(&["20"])
}

/// The exit code of a chore of one step.
fn exit_code(done: Result<Finding, Failure>) -> ExitCode {
    match done {
        Ok(_) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{}", failure.reason);
            ExitCode::FAILURE
        }
    }
}

fn doc_tests() -> Result<Finding, Failure> {
    run_counted(cargo().arg("test").args(WORKSPACE).args(["--doc", "--no-fail-fast"]))
        .map(Finding::Tested)
}

fn documentation() -> Result<Finding, Failure> {
    run(
        cargo().arg("doc").args(WORKSPACE).arg("--no-deps").env("RUSTDOCFLAGS", "-D warnings"),
        "warnings count as errors",
    )?;
    Ok(Finding::Done)
}
