//! Stress against the yield strength.

use super::{Finding, Kind, Level, interval::beyond_one};

/// A use of the yield strength that is reported: the inverse of the design factor of 1.25 that is
/// common for drill pipe.
pub const YIELD_USE_WARNING: f64 = 0.8;

/// The stretches on which the largest stress comes near the yield strength: warnings beyond
/// [`YIELD_USE_WARNING`], errors beyond one. Rows whose yield strength is not known bear all.
pub fn yield_use(md_m: &[f64], yield_use: &[Option<f64>]) -> Vec<Finding> {
    let use_of = |row: usize| yield_use[row].unwrap_or(0.0);
    let measure: Vec<f64> =
        (0..yield_use.len()).map(|row| use_of(row) / YIELD_USE_WARNING).collect();
    let finding = |of: super::interval::Interval| {
        let worst = use_of(of.worst);
        let level = if worst > 1.0 { Level::Error } else { Level::Warning };
        Finding::new(Kind::YieldUse, level).over(of.md_m).value(worst).limit(if worst > 1.0 {
            1.0
        } else {
            YIELD_USE_WARNING
        })
    };
    beyond_one(md_m, &measure).into_iter().map(finding).collect()
}
