//! Outcome of a case.

use serde::{Deserialize, Serialize};
use wholestring_contain::{Panicked, contain};
use wholestring_results::OperationSummary;

use crate::{error::mistake_of, run::Stop};

/// Outcome of a case.
pub(crate) struct Ending {
    pub(crate) solved: Vec<OperationSummary>,
    /// `None` if it is finished.
    pub(crate) why: Option<Stop>,
    /// Simulated time solved by an earlier batch, s.
    pub(crate) reused_s: f64,
}

impl Ending {
    /// Runs the work on a case and returns its outcome. A panic in one case does not end the
    /// others.
    pub(crate) fn of(work: impl FnOnce() -> Result<Self, Stop>) -> Self {
        contain(work)
            .unwrap_or_else(|Panicked(mistake)| Err(Stop::Unsolved(mistake_of(&mistake))))
            .unwrap_or_else(|why| Self { solved: Vec::new(), why: Some(why), reused_s: 0.0 })
    }
}

/// Outcome of a case that was [solved separately](super::RemoteCase), for transfer between
/// processes.
#[derive(Debug, Serialize, Deserialize)]
pub struct Ended {
    solved: Vec<OperationSummary>,
    end: End,
}

#[derive(Debug, PartialEq, Serialize, Deserialize)]
enum End {
    Finished,
    Interrupted,
    Failed(String),
}

impl Ended {
    /// A case without results, for this reason.
    pub fn failed(reason: String) -> Self {
        Self { solved: Vec::new(), end: End::Failed(reason) }
    }

    /// Whether it was stopped before its end.
    pub fn is_interrupted(&self) -> bool {
        self.end == End::Interrupted
    }
}

impl From<Ending> for Ended {
    fn from(ending: Ending) -> Self {
        let end = match ending.why {
            None => End::Finished,
            Some(Stop::Interrupted) => End::Interrupted,
            Some(why) => End::Failed(why.to_string()),
        };
        Self { solved: ending.solved, end }
    }
}

impl From<Ended> for Ending {
    fn from(ended: Ended) -> Self {
        let why = match ended.end {
            End::Finished => None,
            End::Interrupted => Some(Stop::Interrupted),
            End::Failed(reason) => Some(Stop::Unsolved(reason)),
        };
        Self { solved: ended.solved, why, reused_s: 0.0 }
    }
}
