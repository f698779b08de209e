//! Arguments of `wholestring plan`.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring_runner::job::{Job, Work};

use crate::shared_args::{CaseArgs, CheckpointArgs, PageArgs, output};

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

    /// Continue an interrupted plan; finished points are skipped
    #[arg(long)]
    pub(crate) resume: bool,

    /// Overwrite existing results in the folder: another plan or an unfinished one
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    /// Overlay curves from another program: a CSV or Excel file of hook loads and torques against
    /// bit depth, in the format of measured values
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
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Plan { overlay: self.overlay.clone(), png: self.page.png };
        Job {
            output: output(self.output.as_ref(), self.resume, self.overwrite),
            units: self.page.units,
            jobs: self.jobs,
            checkpoint: self.checkpoint.every.clone(),
            ..self.case.job(work)
        }
    }
}
