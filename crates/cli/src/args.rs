//! The command line: its commands, each of which declares its arguments.

use clap::{Parser, Subcommand};
use clap_complete::Shell;

use crate::{
    app::AppArgs,
    bench::BenchArgs,
    bha::BhaArgs,
    bit_test::BitTestArgs,
    calibrate::CalibrateArgs,
    catalogue::CatalogueArgs,
    check::CheckArgs,
    export::ExportArgs,
    import::ImportArgs,
    modes::ModesArgs,
    new_case::NewArgs,
    plan::PlanArgs,
    reach::ReachArgs,
    report::{PlotArgs, ReportArgs},
    run::RunArgs,
    survey::SurveyArgs,
    sweep::{StudyArgs, SweepArgs},
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

// In the order of the help text.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    // First steps.
    /// Write a commented case file as a starting point
    New(NewArgs),
    /// Build a commented case from surveys, tallies, WITSML, EDM and logs
    Import(ImportArgs),
    /// Open a folder of cases in the browser
    App(AppArgs),
    /// Check that a case is valid, or list the contents of another program's file
    Check(CheckArgs),

    // The whole string.
    /// Solve a case and write its results
    Run(RunArgs),
    /// Solve a case for every combination of given values
    Sweep(SweepArgs),
    /// Solve the cases of a study and draw its figures and tables
    Study(StudyArgs),

    // A planned well, and a well being drilled.
    /// Compute torque and drag against bit depth for low, expected and high friction
    Plan(PlanArgs),
    /// Find how far the well can be extended in its last direction, and the limit that stops it
    Reach(ReachArgs),
    /// Fit friction factors and block weight to measured weights and torques
    Calibrate(CalibrateArgs),

    // Assembly and bit.
    /// Static analysis of the bottom-hole assembly: side force of the bit, contacts, bending, sag
    Bha(BhaArgs),
    /// Find natural frequencies, critical speeds and the response to a rotating force
    Modes(ModesArgs),
    /// Drill with the bit alone at every weight on bit and rotary speed of [bit_test]
    BitTest(BitTestArgs),

    // Results folders.
    /// Rebuild the report page of a results folder
    Report(ReportArgs),
    /// Draw results as SVG files; two runs can share the axes
    Plot(PlotArgs),
    /// Write results, or the survey or string of a case, as CSV, Excel, text or WITSML
    Export(ExportArgs),

    // Reference data.
    /// Compute position and dogleg severity along a survey
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
