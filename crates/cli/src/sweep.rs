//! `wholestring sweep`: solves a case for all combinations of some values.

use clap::Args;
use wholestring_runner::job::{Job, SweepOptions, Varied, Work};

use crate::shared_args::{BatchArgs, CaseArgs, KeptArgs};

#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Values of a key, such as `friction=0.1,0.2,0.3` or `bit_depth=300m..4305m/300m` (a range
    /// always includes its end). Repeatable: every combination is a case, the last key varying
    /// fastest
    #[arg(long, value_name = "KEY=VALUES", required = true)]
    pub(crate) vary: Vec<String>,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) kept: KeptArgs,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

impl SweepArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Sweep(SweepOptions {
            vary: self.vary.iter().cloned().map(Varied::Text).collect(),
            together: false,
            cases: self.kept.of_cases(&self.batch),
        });
        self.batch.applied_to(self.case.job(work))
    }
}
