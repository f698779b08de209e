//! The map of torsional stability on paper.

mod figure;

pub(crate) use figure::stability_figure;

/// The map of torsional stability. Numbers are SI; one that is not known is not finite.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityPicture {
    /// Rotary speeds, rad/s, increasing.
    pub speeds_rad_per_s: Vec<f64>,
    /// Weights on bit, N, increasing.
    pub weights_N: Vec<f64>,
    /// Growth rate of the fastest growing motion, 1/s: for the first weight at each speed, then for
    /// the next.
    pub growth_per_s: Vec<f64>,
    /// Speed from which each weight is stable, rad/s; not a number where all are, or none is.
    pub thresholds_rad_per_s: Vec<f64>,
    /// The case's own rotary speed, rad/s, and weight on bit, N.
    pub own: [f64; 2],
}

#[cfg(test)]
mod tests;
