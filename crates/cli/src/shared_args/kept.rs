//! What is kept of each of many cases.

use clap::{Args, ValueEnum};
use wholestring_runner::Keep;

use super::batch::BatchArgs;
use crate::failure::Failure;

/// What is kept of each case.
#[derive(Debug, Args)]
pub(crate) struct KeptArgs {
    /// Results to keep of each case [default: tables for the dynamic model, for --csv and where a
    /// figure needs them; otherwise the summary]
    #[arg(long, value_enum, value_name = "WHAT")]
    keep: Option<KeepArg>,
}

/// What is kept of a case, each with what stands before it.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum KeepArg {
    /// `summary.json`
    Summary,
    /// Tables too
    Tables,
    /// All results of a run: the page and the picture too
    All,
}

impl KeptArgs {
    /// What they ask to keep, if anything.
    pub(crate) fn keep(&self) -> Option<Keep> {
        self.keep.map(|keep| match keep {
            KeepArg::Summary => Keep::Summary,
            KeepArg::Tables => Keep::Tables,
            KeepArg::All => Keep::All,
        })
    }

    /// Refuses tables as CSV where none are kept.
    pub(crate) fn check(&self, batch: &BatchArgs) -> Result<(), Failure> {
        if batch.csv && self.keep() == Some(Keep::Summary) {
            return Err(Failure::BadInput(
                "error: --csv writes tables, --keep summary keeps none: leave out one of them"
                    .into(),
            ));
        }
        Ok(())
    }
}
