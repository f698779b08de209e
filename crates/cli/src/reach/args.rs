//! `wholestring reach` as the user writes it.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring_runner::Output;

use crate::shared_args::{CaseArgs, PageArgs, existing};

#[derive(Debug, Args)]
pub(crate) struct ReachArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Depth of the bit to begin with, such as `4000m` [default: the end of the survey]
    #[arg(long, value_name = "DEPTH")]
    pub(crate) from: Option<String>,

    /// Deepest bit, such as `12km` [default: 15 km, or twice the first depth where that is deeper]
    #[arg(long, value_name = "DEPTH")]
    pub(crate) to: Option<String>,

    /// Friction factors of all sections, one after the other, such as `0.2,0.3,0.4` [default: the
    /// case's own]
    #[arg(long, value_name = "FACTORS")]
    pub(crate) friction: Option<String>,

    /// Operations, such as `drill,slide` [default: trip_out, rotate_off_bottom, drill, trip_in,
    /// slide and those of the case, as far as it has their set points]
    #[arg(long, value_name = "KINDS")]
    pub(crate) operation: Option<String>,

    /// Leave out the friction of what a helix presses to the wall: nothing locks up
    #[arg(long)]
    pub(crate) no_helix_friction: bool,

    /// Count the depth where a helix begins as a stop: the string goes on buckled otherwise. Not
    /// where the hole is vertical, where it buckles early and is held
    #[arg(long)]
    pub(crate) stop_at_helix: bool,

    /// Number of parallel jobs, an operation each [default: one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name> reach]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue with a reach of uncertain numbers that was interrupted: leave out samples that are
    /// solved
    #[arg(long)]
    pub(crate) resume: bool,

    /// Replace what lies in the folder
    #[arg(long, conflicts_with = "resume")]
    pub(crate) overwrite: bool,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}

impl ReachArgs {
    /// Where the results go.
    pub(crate) fn output(&self) -> Output {
        Output {
            folder: self.output.clone(),
            existing: existing(self.resume, self.overwrite),
            ..Output::default()
        }
    }
}
