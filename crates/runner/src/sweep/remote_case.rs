//! A case of a sweep that is solved apart from the others: in another process, or on another
//! machine.

use std::{path::Path, time::Duration};

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

/// A case of a sweep that is solved apart from the others.
#[derive(Debug, Clone, Copy)]
pub struct RemoteCase<'a> {
    /// The case file.
    pub template: &'a Template,
    /// What is changed in it.
    pub changes: &'a [Override],
    /// What messages call it.
    pub name: &'a str,
    /// What is kept of it, as in the request of the sweep.
    pub keep: Option<Keep>,
    /// Whether to write the tables that are kept as CSV too.
    pub csv: bool,
    /// Wall-clock time between checkpoints; the case's by default.
    pub checkpoint_every: Option<Duration>,
}

impl RemoteCase<'_> {
    /// Solves it into the folder; what is finished there is left alone, and what was begun is
    /// continued.
    pub fn solve(
        &self,
        folder: &Path,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Ended {
        Ending::of(|| {
            let case = self.template.case(self.changes);
            let case = case.map_err(|report| Stop::Unsolved(report.render(false)))?;
            let one = OneCase {
                case: &case,
                label: self.name,
                simulated_s: 0.0,
                keep: self.keep.unwrap_or_else(|| Keep::of_itself(&case, self.csv)),
                csv: self.csv,
                existing: Existing::Resume,
                checkpoint_every: self.checkpoint_every,
                watch: Watch { observer, case: 0 },
                cancellation,
            };
            one.solve(&ResultsFolder::create(folder)?)
        })
        .into()
    }
}
