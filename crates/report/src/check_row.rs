//! A check as a page shows it.

use serde::{Deserialize, Serialize};
use wholestring_judge::Severity;

use crate::Cell;

/// A check as a page shows it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckRow {
    /// What is compared or reported, as a word for programs: `lock_up`, ...
    pub kind: String,
    /// The same for people.
    pub label: String,
    /// How serious it is.
    pub severity: Severity,
    /// The verdict in words: `OK`, `exceeded`, ...
    pub verdict: String,
    /// The component; empty of the rig and of the whole string.
    pub component: String,
    /// Measured depth of the place or of the upper end of its interval, m; none without a place.
    pub md_m: Option<f64>,
    /// Measured depth of the lower end of its interval, m; none of a point and without a place.
    pub to_md_m: Option<f64>,
    /// The value, of a limit the load; nothing where it is no number.
    pub value: Cell,
    /// What it is compared with, of a limit the capacity; nothing where there is no such number.
    pub limit: Cell,
    /// Capacity over load; none of what is no limit.
    pub factor: Option<f64>,
    /// The required factor; none of what is no limit.
    pub required: Option<f64>,
    /// A sentence for people, with numbers in the units of the case.
    pub sentence: String,
}
