//! Arguments of `wholestring bit-test`.

use clap::Args;
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
