//! Arguments of `wholestring bit-test`.

use clap::Args;
use wholestring_runner::job::{Job, Work};
use wholestring_units::UnitSet;

use crate::shared_args::{BatchArgs, CaseArgs};

#[derive(Debug, Args)]
pub(crate) struct BitTestArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Exit with status 4 if a check of the points is an error
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

impl BitTestArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::BitTest { shard: self.batch.shard.clone(), csv: self.batch.csv };
        self.batch.applied_to(Job { units: self.units, ..self.case.job(work) })
    }
}
