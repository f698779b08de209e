//! Batches of cases or points, and their output folder.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring_runner::job::Job;

use super::{checkpoint::CheckpointArgs, output::output, screen::ScreenOptions};

/// Arguments of a batch of cases.
#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// Number of parallel jobs, a case each [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Solve only the I-th of N equal shares of the cases
    #[arg(long, value_name = "I/N")]
    pub(crate) shard: Option<String>,

    /// Skip the finished cases in the folder and continue unfinished ones from their checkpoints
    #[arg(long)]
    pub(crate) resume: bool,

    /// Overwrite existing results in the folder: other cases or unfinished ones
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(short, long, value_name = "DIR", help = "Folder for the results [default: out/<name>]")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Also write the tables as CSV
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl BatchArgs {
    /// The job with the settings of these arguments.
    pub(crate) fn applied_to(&self, job: Job) -> Job {
        Job {
            output: output(self.output.as_ref(), self.resume, self.overwrite),
            jobs: self.jobs,
            checkpoint: self.checkpoint.every.clone(),
            ..job
        }
    }

    /// Options of the screen.
    pub(crate) fn screen(&self, strict: bool) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict, json: false }
    }
}
