//! The command line as the user writes it: its commands, each of which declares its arguments.

use clap::{Parser, Subcommand};
use clap_complete::Shell;

use crate::{
    app::AppArgs, bench::BenchArgs, bha::BhaArgs, bit_test::BitTestArgs, calibrate::CalibrateArgs,
    catalogue::CatalogueArgs, check::CheckArgs, export::ExportArgs, import::ImportArgs,
    modes::ModesArgs, new_case::NewArgs, plan::PlanArgs, plot::PlotArgs, reach::ReachArgs,
    report::ReportArgs, run::RunArgs, study::StudyArgs, survey::SurveyArgs, sweep::SweepArgs,
};

/// Torque, drag and dynamics of a whole drill string in a deviated well.
#[derive(Debug, Parser)]
#[command(name = "wholestring", version, max_term_width = 100, after_help = EXIT_STATUS)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXIT_STATUS: &str = "\
Exit status: 0 done; 2 bad input; 3 the run failed; 4 an error was found, with --strict; 130 \
interrupted.";

// In the order in which help shows them.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    // To begin with.
    /// Write a commented case to begin with
    New(NewArgs),
    /// Make a commented case of surveys, tallies, WITSML, EDM and logs
    Import(ImportArgs),
    /// Open a folder of cases in the browser
    App(AppArgs),
    /// Is the case valid? One line, or diagnostics. Of a file of another program: what it holds
    Check(CheckArgs),

    // The whole string.
    /// Solve a case and write its results
    Run(RunArgs),
    /// Solve a case for all combinations of some values
    Sweep(SweepArgs),
    /// Solve the cases of a study and make its figures and tables
    Study(StudyArgs),

    // A well that is planned, and one that is drilled.
    /// Torque and drag at every depth of the bit, with low, expected and high friction
    Plan(PlanArgs),
    /// How far the well can go in its last direction, and what stops it
    Reach(ReachArgs),
    /// Find friction factors and block weight from weights and torques that were read
    Calibrate(CalibrateArgs),

    // The assembly, the bit.
    /// Static analysis of the bottom-hole assembly: side force of the bit, contacts, bending, sag
    Bha(BhaArgs),
    /// Find natural frequencies, critical speeds and the response to a rotating force
    Modes(ModesArgs),
    /// Try the bit alone on its rock under every weight at every speed
    BitTest(BitTestArgs),

    // What lies in folders of results.
    /// Make the page of results again
    Report(ReportArgs),
    /// Draw what results hold as SVG files; a second run on the same axes
    Plot(PlotArgs),
    /// Write results, or the survey or string of a case, as CSV, Excel, text or WITSML
    Export(ExportArgs),

    // To look things up.
    /// Position and dogleg severity along a survey
    Survey(SurveyArgs),
    /// List the pipes, collars and casings that a case can name
    Catalogue(CatalogueArgs),
    /// Print the JSON schema of the case file
    Schema,

    // The program itself.
    /// Measure this machine's speed at this work
    Bench(BenchArgs),
    /// Print a script that completes commands and options in a shell
    Completions {
        /// The shell
        #[arg(value_enum, value_name = "SHELL")]
        shell: Shell,
    },
    /// Print the manual page
    Man,
}
