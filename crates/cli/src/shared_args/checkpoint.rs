//! Interval between checkpoints.

use clap::Args;

#[derive(Debug, Args)]
pub(crate) struct CheckpointArgs {
    /// Wall-clock time between checkpoints, such as 5min [default: the case's, 30 s]
    #[arg(long = "checkpoint", value_name = "TIME")]
    pub(crate) every: Option<String>,
}
