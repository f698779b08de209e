//! `wholestring plan` as the user writes it.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring_runner::Output;

use crate::shared_args::{CaseArgs, CheckpointArgs, PageArgs, existing};

#[derive(Debug, Args)]
#[command(mut_arg("units", |arg| {
    arg.help("Units on the screen, the page and in the workbook [default: the case's]")
}))]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> plan]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue with a plan that was interrupted: leave out what is finished
    #[arg(long)]
    pub(crate) resume: bool,

    /// Replace what lies in the folder: other results, or what was not finished
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    /// Overlay curves from another program: a file of hook loads and torques against bit depth, as measured ones are, CSV or Excel
    #[arg(long, value_name = "FILE")]
    pub(crate) overlay: Option<PathBuf>,

    /// Number of parallel jobs [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}

impl PlanArgs {
    /// Where the results go.
    pub(crate) fn output(&self) -> Output {
        Output {
            folder: self.output.clone(),
            existing: existing(self.resume, self.overwrite),
            ..Output::default()
        }
    }
}
