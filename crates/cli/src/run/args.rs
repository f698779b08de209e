//! Arguments of `wholestring run`.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring_runner::Output;
use wholestring_units::UnitSet;

use crate::shared_args::{CaseArgs, CheckpointArgs, existing};

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
    /// Folder of the results and how existing results are treated.
    pub(crate) fn output(&self) -> Output {
        Output {
            folder: self.resume.clone().or_else(|| self.output.clone()),
            existing: existing(self.resume.is_some(), self.overwrite),
            ..Output::default()
        }
    }
}
