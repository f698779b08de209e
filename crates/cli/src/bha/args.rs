//! Arguments of `wholestring bha`.

use std::num::NonZeroUsize;

use clap::Args;
use wholestring::operation::OperationKind;
use wholestring_runner::job::{BhaOptions, Job, Work, operation};
use wholestring_units::UnitSet;

use crate::shared_args::{CaseArgs, OutputArgs, ScreenOptions};

#[derive(Debug, Args)]
// Not a doc comment, which would read `<case name>` as HTML.
#[command(mut_arg("output", |arg| {
    arg.help("Folder for the results [default: out/<case name> bha]")
}))]
pub(crate) struct BhaArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Operation: drill, slide, trip_out, ... [default: the case's first one that drills]
    #[arg(long, value_name = "KIND", value_parser = operation)]
    pub(crate) operation: Option<OperationKind>,

    /// Tool faces of the bend, such as `90deg` or `0deg..360deg/15deg` (a range always includes its
    /// end) [default: a revolution in steps of 15 deg]
    #[arg(long, value_name = "ANGLES")]
    pub(crate) toolface: Option<String>,

    /// Weights on bit, such as `20kN..120kN/20kN` [default: seven values up to 1.5 times the
    /// operation's]
    #[arg(long, value_name = "FORCES")]
    pub(crate) weight: Option<String>,

    /// Inclinations of a straight hole, such as `5deg..90deg/5deg` [default: 5deg..90deg/5deg]
    #[arg(long, value_name = "ANGLES")]
    pub(crate) inclination: Option<String>,

    /// Build rate of the holes of --inclination, such as `2deg/30m`; negative to drop [default: 0,
    /// straight]
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    pub(crate) build: Option<String>,

    /// Solve the whole string instead of the assembly and 100 m of pipe above it
    #[arg(long)]
    pub(crate) whole: bool,

    /// Number of parallel jobs, a point each [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    #[command(flatten)]
    pub(crate) output: OutputArgs,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Also write the tables as CSV
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,
}

impl BhaArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Bha(BhaOptions {
            operation: self.operation,
            whole: self.whole,
            toolface: self.toolface.clone(),
            weight: self.weight.clone(),
            inclination: self.inclination.clone(),
            build: self.build.clone(),
            csv: self.csv,
        });
        let (output, units, jobs) = (self.output.output(), self.units, self.jobs);
        Job { output, units, jobs, ..self.case.job(work) }
    }

    /// Options of the screen.
    pub(crate) fn screen(&self) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict: self.strict, json: false }
    }
}
