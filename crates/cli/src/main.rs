//! The `wholestring` command: case files in, torque and drag out.

mod args;
mod bench;
#[path = "../../runner/src/bit_test/mod.rs"]
mod bit_test;
mod catalogue;
mod check;
#[path = "../../runner/src/checkpoint/laid.rs"]
mod checkpoint;
#[path = "../../runner/src/claim/folder.rs"]
mod claim;
#[path = "../../runner/src/column.rs"]
mod column;
mod comparison;
mod conclusion;
#[path = "../../runner/src/cores.rs"]
mod cores;
mod failure;
#[path = "../../runner/src/findings/mod.rs"]
mod findings;
#[path = "../../runner/src/folder_name.rs"]
mod folder_name;
#[path = "../../runner/src/record/frames.rs"]
mod frames;
mod interrupt;
#[path = "../../runner/src/keep.rs"]
mod keep;
mod new_case;
mod pace;
#[path = "../../runner/src/parallel.rs"]
mod parallel;
#[path = "../../runner/src/pictures.rs"]
mod plot;
mod progress;
#[path = "../../runner/src/record/mod.rs"]
mod record;
#[path = "../../runner/src/page/run.rs"]
mod report;
#[path = "../../runner/src/run/request.rs"]
mod run;
mod screen_table;
mod shell;
#[path = "../../runner/src/run/solve.rs"]
mod solve;
#[path = "../../runner/src/study/mod.rs"]
mod study;
mod survey;
#[path = "../../runner/src/sweep/mod.rs"]
mod sweep;

use std::{
    env,
    io::{self, IsTerminal, Write},
    process::ExitCode,
};

use clap::Parser;

use args::{CaseArgs, Cli, Command};
use failure::Failure;

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Check(args) => check::check(&args),
        Command::Run(args) => run::run(&args),
        Command::Sweep(args) => sweep::sweep(&args),
        Command::BitTest(args) => bit_test::bit_test(&args),
        Command::Study(args) => study::study(&args),
        Command::Report(args) => report::report(&args),
        Command::Plot(args) => plot::plot(&args),
        Command::Survey(args) => survey::survey(&args),
        Command::Bench(args) => bench::bench(&args),
        Command::Catalogue(args) => catalogue::catalogue(&args),
        Command::New(args) => new_case::new(&args),
        Command::Schema => schema(),
        Command::Completions(args) => shell::completions(&args),
        Command::Man => shell::man(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            tell(&format!("{failure}\n"));
            ExitCode::from(failure.status())
        }
    }
}

fn schema() -> Result<(), Failure> {
    let schema = wholestring_case::schema();
    say(&format!("{schema:#}\n"))
}

/// Reads the case with its overrides, and tells its warnings.
fn load(args: &CaseArgs, quiet: bool) -> Result<wholestring_case::Case, Failure> {
    let case = wholestring_case::load(&args.case, &args.overrides)
        .map_err(|report| Failure::BadInput(report.render(color())))?;
    if !quiet && !case.warnings.is_empty() {
        tell(&case.warnings.render(color()));
    }
    Ok(case)
}

/// Whether diagnostics are coloured: on a terminal whose user has not said no.
fn color() -> bool {
    io::stderr().is_terminal() && env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}

/// Whether what is printed to standard output is coloured.
fn screen_color() -> bool {
    io::stdout().is_terminal() && env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}

/// Prints to standard error. Where that is closed or full there is nobody left to tell.
fn tell(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Prints to standard output. A reader that has seen enough (`| head`) is no failure.
fn say(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Failed(format!(
            "error: cannot write to standard output: {error}"
        ))),
        _ => Ok(()),
    }
}
