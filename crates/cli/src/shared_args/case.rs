//! A case, and overrides of its keys on the command line.

use std::path::PathBuf;

use clap::Args;
use wholestring_case::Override;
use wholestring_runner::job::{Job, Work};

#[derive(Debug, Args)]
pub(crate) struct CaseArgs {
    /// Case file
    #[arg(value_name = "CASE.toml")]
    pub(crate) case: PathBuf,

    /// Set a key of the case, such as `well.hole.0.friction=0.1`; short keys: friction, bit_depth,
    /// rpm, wob. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,
}

impl CaseArgs {
    /// A job for the case, with default settings.
    pub(crate) fn job(&self, work: Work) -> Job {
        Job { set: self.overrides.clone(), ..Job::new(Some(self.case.clone()), work) }
    }
}
