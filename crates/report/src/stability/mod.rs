//! The map of torsional stability on paper.

mod figure;
mod sentences;

pub(crate) use figure::stability_figure;
pub use sentences::stability_sentences;

use wholestring_results::{StabilitySummary, Table};

/// The map of torsional stability as it is drawn. Numbers are SI; one that is not known is not
/// finite.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StabilityPicture {
    /// Rotary speeds, rad/s, increasing.
    pub(crate) speeds_rad_per_s: Vec<f64>,
    /// Weights on bit, N, increasing.
    pub(crate) weights_N: Vec<f64>,
    /// Growth rate of the fastest growing motion, 1/s: for the first weight at each speed, then for
    /// the next.
    pub(crate) growth_per_s: Vec<f64>,
    /// Speed from which each weight is stable, rad/s; not a number where all are, or none is.
    pub(crate) thresholds_rad_per_s: Vec<f64>,
    /// The case's own rotary speed, rad/s, and weight on bit, N.
    pub(crate) own: [f64; 2],
}

impl StabilityPicture {
    /// The map of `stability.parquet`, with the case's own place in it.
    pub(crate) fn new(table: &Table, summary: &StabilitySummary) -> Self {
        let column = |name: &str| table.values(name);
        let all_weights_N = column("weight_on_bit_N");
        let mut weights_N = all_weights_N.clone();
        weights_N.dedup();
        let speeds = all_weights_N.len() / weights_N.len().max(1);
        let thresholds = column("threshold_rad_per_s");
        Self {
            speeds_rad_per_s: column("rotary_speed_rad_per_s").into_iter().take(speeds).collect(),
            weights_N,
            growth_per_s: column("growth_per_s"),
            thresholds_rad_per_s: thresholds.into_iter().step_by(speeds.max(1)).collect(),
            own: [summary.rotary_speed_rad_per_s, summary.weight_on_bit_N],
        }
    }
}

#[cfg(test)]
mod tests;
