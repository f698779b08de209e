//! A check as a page shows it.

use serde::{Deserialize, Serialize};
use wholestring_judge::Severity;

use crate::Cell;

/// A sentence of the judge with the units printed as on a page: `kN·m` for `kN.m`.
pub fn printed(sentence: &str) -> String {
    sentence.replace("N.m", "N·m").replace("ft-lbf", "ft·lbf")
}

/// A check as a page shows it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckRow {
    /// Kind of the check, as a word for programs: `lock_up`, ...
    pub kind: String,
    /// The same for users.
    pub label: String,
    /// Its severity.
    pub severity: Severity,
    /// The verdict in words: `OK`, `exceeded`, ...
    pub verdict: String,
    /// The component; empty for the rig and for the whole string.
    pub component: String,
    /// Measured depth of the place or of the upper end of its interval, m; `None` without a place.
    pub md_m: Option<f64>,
    /// Measured depth of the lower end of its interval, m; `None` for a point and without a place.
    pub to_md_m: Option<f64>,
    /// The value, for a limit the load; empty where it is not a number.
    pub value: Cell,
    /// Number that the value is compared with, for a limit the capacity; empty where there is none.
    pub limit: Cell,
    /// Capacity over load; `None` for a check that is not a limit.
    pub factor: Option<f64>,
    /// The required factor; `None` for a check that is not a limit.
    pub required: Option<f64>,
    /// A sentence for users, in SI, metric and field units.
    pub sentences: [String; 3],
}
