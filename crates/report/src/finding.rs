//! What an engineer must know about a result, as a page shows it.

use serde::{Deserialize, Serialize};

use crate::Cell;

/// How grave a finding is. Worse ones are greater.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Level {
    /// To be known when the answer is read.
    Note,
    /// A limit is near or passed, or a number is less certain than it looks.
    Warning,
    /// The operation cannot be carried out so, or the answer must not be used.
    Error,
}

/// One thing that an engineer must know.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// What was found, as a word for programs: `hook_load_negative`, ...
    pub kind: String,
    /// How grave it is.
    pub level: Level,
    /// Measured depth at which it stands or begins, m; none where it has no place.
    pub md_m: Option<f64>,
    /// Measured depth at which it ends, m; none where it is a point or has no place.
    pub to_md_m: Option<f64>,
    /// What was found; nothing where it is no number.
    pub value: Cell,
    /// What it is compared with; nothing where there is no such number.
    pub limit: Cell,
    /// A sentence for people, with numbers in the units of the case.
    pub message: String,
}
