//! The `wholestring` command: case files in, torque and drag out.

mod app;
mod args;
mod bench;
mod bha;
mod bit_test;
mod calibrate;
mod catalogue;
mod check;
mod checks;
mod color;
mod comparison;
mod conclusion;
mod convergence;
mod export;
mod failure;
mod import;
mod input;
mod interrupt;
mod modes;
mod new_case;
mod plan;
mod plot;
mod progress;
mod reach;
mod report;
mod run;
mod screen_table;
mod shared_args;
mod shell;
mod speed;
mod stopped;
mod study;
mod survey;
mod sweep;
mod terminal;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};
use failure::Failure;
use terminal::{print_stderr, print_stdout};

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::App(args) => app::app(&args),
        Command::Check(args) => check::check(&args),
        Command::Import(args) => import::import(&args),
        Command::Run(args) => run::run(&args),
        Command::Sweep(args) => sweep::sweep(&args),
        Command::BitTest(args) => bit_test::bit_test(&args),
        Command::Bha(args) => bha::bha(&args),
        Command::Calibrate(args) => calibrate::calibrate(&args),
        Command::Modes(args) => modes::modes(&args),
        Command::Plan(args) => plan::plan(&args),
        Command::Reach(args) => reach::reach(&args),
        Command::Study(args) => study::study(&args),
        Command::Report(args) => report::report(&args),
        Command::Plot(args) => plot::plot(&args),
        Command::Export(args) => export::export(&args),
        Command::Survey(args) => survey::survey(&args),
        Command::Bench(args) => bench::bench(&args),
        Command::Catalogue(args) => catalogue::catalogue(&args),
        Command::New(args) => new_case::new(&args),
        Command::Schema => schema(),
        Command::Completions { shell } => shell::completions(shell),
        Command::Man => shell::man(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            print_stderr(&format!("{failure}\n"));
            ExitCode::from(failure.status())
        }
    }
}

fn schema() -> Result<(), Failure> {
    let schema = wholestring_case::schema();
    print_stdout(&format!("{schema:#}\n"))
}
