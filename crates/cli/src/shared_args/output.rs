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
    /// The output options of these arguments.
    pub(crate) fn output(&self) -> Output {
        Output {
            folder: self.output.clone(),
            existing: existing(false, self.overwrite),
            ..Output::default()
        }
    }
}

/// Treatment of existing results in the folder.
pub(crate) fn existing(resume: bool, overwrite: bool) -> Existing {
    match (resume, overwrite) {
        (true, _) => Existing::Resume,
        (_, true) => Existing::Overwrite,
        _ => Existing::Protect,
    }
}
