//! What an engineer must know about a result.

use serde::{Deserialize, Serialize};

pub use wholestring::findings::Level;

/// One thing that an engineer must know about a result: what, where, how much, and what it is
/// compared with.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// What was found, as a word for programs: `hook_load_negative`, `helical_buckling`, ...
    pub kind: String,
    /// How grave it is.
    pub level: Level,
    /// Measured depth at which it stands, or at which its interval begins, m; none where it has no
    /// place.
    #[serde(default)]
    pub md_m: Option<f64>,
    /// Measured depth at which its interval ends, m; none where it is a point or has no place.
    #[serde(default)]
    pub to_md_m: Option<f64>,
    /// The value that was found, in SI units; none where it is no number.
    #[serde(default)]
    pub value: Option<f64>,
    /// What it is compared with, in the same unit; none where there is no such number.
    #[serde(default)]
    pub limit: Option<f64>,
    /// SI unit of value and limit; empty for a ratio.
    #[serde(default)]
    pub unit: String,
    /// A sentence for people, with the numbers in the units of the case.
    pub message: String,
}
