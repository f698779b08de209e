//! A case of a sweep that is solved separately: in another process, or on another machine.

use std::{path::Path, time::Duration};

use serde::{Deserialize, Serialize};
use wholestring_case::{Override, Template};
use wholestring_results::ResultsFolder;

use super::{
    ending::{Ended, Ending},
    one_case::OneCase,
};
use crate::{
    cancellation::CancellationToken,
    keep::Keep,
    observer::{Observer, Watch},
    output::Existing,
    run::Stop,
};

/// A case of a sweep that is solved separately from the others.
#[derive(Debug, Clone, Copy)]
pub struct RemoteCase<'a> {
    /// The case file.
    pub template: &'a Template,
    /// Changes in it.
    pub changes: &'a [Override],
    /// Name of the case in messages.
    pub name: &'a str,
    /// Options of its sweep.
    pub options: RemoteOptions,
}

/// Options of a sweep for cases that are solved separately: [`super::PreparedSweep::remote_options`].
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct RemoteOptions {
    pub(super) keep: Option<Keep>,
    pub(super) csv: bool,
    pub(super) checkpoint_every: Option<Duration>,
}

impl RemoteCase<'_> {
    /// Solves it into the folder; a finished case is not solved again, and an unfinished one is
    /// continued.
    pub fn solve(
        &self,
        folder: &Path,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Ended {
        let RemoteOptions { keep, csv, checkpoint_every } = self.options;
        Ending::of(|| {
            let case = self.template.case(self.changes);
            let case = case.map_err(|report| Stop::Unsolved(report.render(false)))?;
            let one = OneCase {
                case: &case,
                label: self.name,
                simulated_s: 0.0,
                keep: keep.unwrap_or_else(|| Keep::of_itself(&case, csv)),
                csv,
                existing: Existing::Resume,
                checkpoint_every,
                watch: Watch { observer, case: 0 },
                cancellation,
            };
            one.solve(&ResultsFolder::create(folder)?)
        })
        .into()
    }
}
