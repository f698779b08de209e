//! How many cases or points are solved, and where their results go.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring_runner::{BatchOptions, Output, Shard};

use super::{checkpoint::CheckpointArgs, output::existing};

/// How many cases are solved.
#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// Number of parallel jobs, a case each [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Solve the I-th of N equal shares of the cases only
    #[arg(long, value_name = "I/N")]
    pub(crate) shard: Option<Shard>,

    /// Leave out what is finished in the folder, and continue with what is not from its checkpoints
    #[arg(long)]
    pub(crate) resume: bool,

    /// Replace what lies in the folder: the results of other cases, or what was not finished
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(short, long, value_name = "DIR", help = "Folder for the results [default: out/<name>]")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Write the tables as CSV too
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl BatchArgs {
    /// What they ask for.
    pub(crate) fn options(&self) -> BatchOptions {
        BatchOptions {
            output: Output {
                folder: self.output.clone(),
                existing: existing(self.resume, self.overwrite),
                ..Output::default()
            },
            jobs: self.jobs,
            shard: self.shard.unwrap_or_default(),
            checkpoint_every: self.checkpoint.every,
            csv: self.csv,
        }
    }
}
