//! Settings of a reach.

use wholestring::{
    statics::soft::{SoftError, SoftSettings},
    string::AssemblyError,
};
use wholestring_judge::DesignFactors;

/// Settings of a reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReachSettings {
    /// First depth of the bit, m.
    pub from_m: f64,
    /// Deepest bit, m, up to 100 km.
    pub to_m: f64,
    /// Number of depths of the grid, at least two. A limit that is exceeded only between two of
    /// them is not detected, except where a component passes a curved stretch.
    pub depths: usize,
    /// Settings of the soft string, including whether the wall force of a helix causes friction;
    /// without that a string never locks up.
    pub soft: SoftSettings,
    /// Whether the string stops where its helix begins, though it would continue buckled.
    pub stop_at_helix: bool,
    /// Tolerance of a depth, m.
    pub tolerance_m: f64,
    /// The required factors of the limits of string and rig.
    pub factors: DesignFactors,
}

impl ReachSettings {
    /// Default deepest bit, m: a little more than the longest wells.
    pub const TO_M: f64 = 15_000.0;

    /// Returns settings from a depth to the default one, m, or to twice that depth where this is
    /// deeper, with friction of the helix.
    pub fn from_depth(from_m: f64) -> Self {
        Self {
            from_m,
            to_m: Self::TO_M.max(2.0 * from_m),
            depths: 61,
            soft: SoftSettings { step_m: 5.0, helix_side_force: true },
            stop_at_helix: false,
            tolerance_m: 0.01,
            factors: DesignFactors::default(),
        }
    }

    /// Returns the depths of the grid, m.
    pub fn grid_m(&self) -> Vec<f64> {
        let last = self.depths.max(2) - 1;
        let depth_m = |index: usize| match index == last {
            true => self.to_m,
            false => self.from_m + (self.to_m - self.from_m) * index as f64 / last as f64,
        };
        (0..=last).map(depth_m).collect()
    }
}

/// The reason why a reach is not found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReachError {
    /// Its first depth is not above its last.
    #[error("the reach is requested from {from_m:.0} m to {to_m:.0} m, which is not deeper")]
    Depths {
        /// First depth, m.
        from_m: f64,
        /// Last depth, m.
        to_m: f64,
    },
    /// The string does not fit.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// The soft string has no solution, though it does not lock up.
    #[error(transparent)]
    Soft(#[from] SoftError),
    /// It was stopped before it was found.
    #[error("it was stopped")]
    Stopped,
}
