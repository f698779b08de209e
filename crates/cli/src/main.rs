//! The `wholestring` command: case files in, torque and drag out.

mod args;
mod bench;
mod bit_test;
mod catalogue;
mod check;
mod checkpoint;
mod claim;
mod column;
mod comparison;
mod conclusion;
mod cores;
mod failure;
mod findings;
mod folder_name;
mod frames;
mod interrupt;
mod keep;
mod new_case;
mod pace;
mod parallel;
mod plot;
mod progress;
mod record;
mod report;
mod run;
mod screen_table;
mod shell;
mod solve;
mod study;
mod survey;
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
