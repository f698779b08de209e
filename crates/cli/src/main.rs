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
mod comparison;
mod conclusion;
mod export;
mod failure;
mod import;
mod modes;
mod new_case;
mod plan;
mod progress;
mod reach;
mod report;
mod run;
mod screen;
mod shared_args;
mod shell;
mod survey;
mod sweep;
mod terminal;
mod work;

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
        Command::Sweep(args) => work::carry_out(&args.job(), args.batch.screen(args.strict)),
        Command::BitTest(args) => work::carry_out(&args.job(), args.batch.screen(args.strict)),
        Command::Bha(args) => work::carry_out(&args.job(), args.screen()),
        Command::Calibrate(args) => work::carry_out(&args.job(), args.page.screen()),
        Command::Modes(args) => work::carry_out(&args.job(), args.page.screen()),
        Command::Plan(args) => work::carry_out(&args.job(), args.page.screen()),
        Command::Reach(args) => work::carry_out(&args.job(), args.page.screen()),
        Command::Study(args) => work::carry_out(&args.job(), args.batch.screen(args.strict)),
        Command::Report(args) => report::report(&args),
        Command::Plot(args) => report::plot(&args),
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
