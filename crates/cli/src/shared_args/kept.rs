//! Results to keep of each of many cases.

use clap::{Args, ValueEnum};
use wholestring_runner::{Keep, job::CasesOptions};

use super::batch::BatchArgs;

/// Results to keep of each case.
#[derive(Debug, Args)]
pub(crate) struct KeptArgs {
    /// Results to keep of each case [default: tables for the dynamic model, for --csv and where a
    /// figure needs them; otherwise the summary]
    #[arg(long, value_enum, value_name = "WHAT")]
    keep: Option<KeepArg>,
}

/// Results to keep of a case; each level includes the preceding ones.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum KeepArg {
    /// `summary.json`
    Summary,
    /// Tables in addition.
    Tables,
    /// All results of a run, including the page and the picture.
    All,
}

impl KeptArgs {
    /// The options of the cases of a batch.
    pub(crate) fn of_cases(&self, batch: &BatchArgs) -> CasesOptions {
        let keep = self.keep.map(|keep| match keep {
            KeepArg::Summary => Keep::Summary,
            KeepArg::Tables => Keep::Tables,
            KeepArg::All => Keep::All,
        });
        CasesOptions { keep, shard: batch.shard.clone(), csv: batch.csv }
    }
}
