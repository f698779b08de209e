//! Output folder of commands that write their results in one step.

use std::path::PathBuf;

use clap::Args;
use wholestring_runner::{Existing, Output};

#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    /// Folder for the results [default: depends on the command]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,

    /// Overwrite existing results in the folder
    #[arg(long)]
    overwrite: bool,
}

impl OutputArgs {
    /// The destination of these arguments.
    pub(crate) fn output(&self) -> Output {
        output(self.output.as_ref(), false, self.overwrite)
    }
}

/// A folder for results, with the treatment of existing results in it.
pub(crate) fn output(folder: Option<&PathBuf>, resume: bool, overwrite: bool) -> Output {
    let existing = match (resume, overwrite) {
        (true, _) => Existing::Resume,
        (_, true) => Existing::Overwrite,
        _ => Existing::Protect,
    };
    Output { folder: folder.cloned(), existing, ..Output::default() }
}
