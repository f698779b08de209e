//! How a case ended.

use serde::{Deserialize, Serialize};
use wholestring_contain::{Panicked, contain};
use wholestring_results::OperationSummary;

use crate::{error::mistake_of, run::Stop};

/// How a case ended.
pub(crate) struct Ending {
    pub(crate) solved: Vec<OperationSummary>,
    /// Nothing where it is finished.
    pub(crate) why: Option<Stop>,
    /// Simulated time that an earlier batch had solved, s.
    pub(crate) reused_s: f64,
}

impl Ending {
    /// How the work on a case ended. A mistake of the program in one case is no reason to lose the
    /// others.
    pub(crate) fn of(work: impl FnOnce() -> Result<Self, Stop>) -> Self {
        contain(work)
            .unwrap_or_else(|Panicked(mistake)| Err(Stop::Unsolved(mistake_of(&mistake))))
            .unwrap_or_else(|why| Self { solved: Vec::new(), why: Some(why), reused_s: 0.0 })
    }
}

/// How a case ended that was [solved by itself](super::RemoteCase), as it goes from one process to another.
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
    /// A case of which nothing was solved, for this reason.
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
