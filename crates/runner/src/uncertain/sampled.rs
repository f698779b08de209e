//! Result of a sample.

use serde::{Deserialize, Serialize};
use wholestring::operation::OperationKind;
use wholestring_judge::DepthLimit;

/// Result of a sample: a value of each quantity, in order.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Sampled {
    /// `None` for a quantity without a value.
    pub(crate) answers: Vec<Option<f64>>,
    /// Number of points without a solution.
    pub(crate) lacking: usize,
    /// Reason of the first of them.
    pub(crate) message: Option<String>,
    /// For a reach, the operation and the limit that stop the well first, at each friction factor.
    pub(crate) stops: Vec<Option<(OperationKind, DepthLimit)>>,
}

impl Sampled {
    /// A sample whose case is invalid or without any solution; `points` of them are counted.
    pub(crate) fn none(answers: usize, points: usize, message: String) -> Self {
        Self {
            answers: vec![None; answers],
            lacking: points,
            message: Some(message),
            ..Self::default()
        }
    }

    /// Counts a point without a solution.
    pub(crate) fn lacks(&mut self, message: impl FnOnce() -> String) {
        self.lacking += 1;
        self.message.get_or_insert_with(message);
    }
}
