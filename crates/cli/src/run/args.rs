//! Arguments of `wholestring run`.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring_runner::job::{Job, Work};
use wholestring_units::UnitSet;

use crate::shared_args::{CaseArgs, CheckpointArgs, ScreenOptions, output};

#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name>]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue with the run in this folder from its checkpoint
    #[arg(long, value_name = "DIR", conflicts_with_all = ["output", "overwrite"])]
    pub(crate) resume: Option<PathBuf>,

    /// Overwrite existing results in the folder: another case or an unfinished run
    #[arg(long)]
    pub(crate) overwrite: bool,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Run the case again with elements of half the length, in the subfolder `halved`, and print
    /// the differences
    #[arg(long, conflicts_with_all = ["resume", "json"])]
    pub(crate) converge: bool,

    /// Number of threads for the solid rock under the bit; results do not depend on it [default:
    /// one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,

    /// Also write the tables as CSV
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print the summary as JSON in place of the table
    #[arg(long)]
    pub(crate) json: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl RunArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let folder = self.resume.as_ref().or(self.output.as_ref());
        Job {
            output: output(folder, self.resume.is_some(), self.overwrite),
            units: self.units,
            jobs: self.jobs,
            checkpoint: self.checkpoint.every.clone(),
            ..self.case.job(Work::Run { models: Vec::new(), csv: self.csv })
        }
    }

    /// Options of the screen.
    pub(crate) fn screen(&self) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict: self.strict, json: self.json }
    }
}
