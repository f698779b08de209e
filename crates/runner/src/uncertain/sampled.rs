//! What came of a sample.

use serde::{Deserialize, Serialize};

/// What came of a sample: an answer to each quantity, in their order.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Sampled {
    /// None where there is no answer.
    pub(crate) answers: Vec<Option<f64>>,
    /// How many points have none.
    pub(crate) lacking: usize,
    /// Why the first of them has none.
    pub(crate) message: Option<String>,
    /// Of a reach, at each friction the operation and the limit that stop the well first.
    pub(crate) stops: Vec<Option<(String, String)>>,
}

impl Sampled {
    /// One that is no case, or has no answer at all to so many points.
    pub(crate) fn none(answers: usize, points: usize, message: String) -> Self {
        Self {
            answers: vec![None; answers],
            lacking: points,
            message: Some(message),
            ..Self::default()
        }
    }

    /// Counts a point without an answer.
    pub(crate) fn lacks(&mut self, message: impl FnOnce() -> String) {
        self.lacking += 1;
        self.message.get_or_insert_with(message);
    }
}
