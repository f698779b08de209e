//! `wholestring run` as the user writes it.

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

    /// Replace what lies in the folder: the results of another case, or an unfinished run
    #[arg(long)]
    pub(crate) overwrite: bool,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Run the case again with every element halved, in the folder `halved` beside its results, and
    /// print what that changes
    #[arg(long, conflicts_with_all = ["resume", "json"])]
    pub(crate) converge: bool,

    /// Threads that work on solid rock under the bit; the answer is the same
    /// [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// End with status 4 where an error is found in an answer
    #[arg(long)]
    pub(crate) strict: bool,

    /// Write the tables as CSV too
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
    /// Where the results go.
    pub(crate) fn output(&self) -> Output {
        Output {
            folder: self.resume.clone().or_else(|| self.output.clone()),
            existing: existing(self.resume.is_some(), self.overwrite),
            ..Output::default()
        }
    }
}
