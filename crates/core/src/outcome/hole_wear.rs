//! Friction work along the hole, stretch by stretch.

use super::{
    column::{columns, unlike_declared},
    method::{IN_TIME, ModelKind},
};

columns! {
    /// Wear of the hole from the surface to the bit, a row per [`HOLE_STEP_M`]. Columns that the
    /// method does not provide are empty.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct HoleWear, "Columns of the wear of the hole, in the order of `wear.parquet`."
    HOLE_WEAR {
        md_m: Vec<f64> => Depth, "Measured depth of the middle of the stretch";
        wear_work_J_per_m: Vec<f64> => WorkPerLength,
            "Work of friction over the window per metre of hole: force times sliding distance",
            known_by IN_TIME;
        wear_power_W_per_m: Vec<f64> => PowerPerLength,
            "Mean rate of the work of friction, for a soft string the rate: force times sliding \
             speed; multiplied by 3600, the work in an hour of the same operation";
    }
}

impl HoleWear {
    /// As [`Profile::unlike_declared`](super::Profile::unlike_declared).
    pub fn unlike_declared(&self, model: ModelKind) -> Vec<&'static str> {
        unlike_declared(HOLE_WEAR, self, model)
    }
}

/// Length of hole that one number of a profile along the hole represents, m.
pub const HOLE_STEP_M: f64 = 5.0;

/// Number of values for a hole down to a depth, m; at least one.
pub(crate) fn hole_steps(to_md_m: f64) -> usize {
    (to_md_m / HOLE_STEP_M).ceil().max(1.0) as usize
}

/// Measured depths of the middles of this many stretches, m.
pub(crate) fn hole_depths_m(steps: usize) -> Vec<f64> {
    (0..steps).map(|i| (i as f64 + 0.5) * HOLE_STEP_M).collect()
}

/// Spreads an amount evenly over a stretch of the hole; the part beyond either end is added at that
/// end.
pub(crate) fn spread(hole: &mut [f64], from_m: f64, to_m: f64, amount: f64) {
    let last = hole.len() - 1;
    let place = |md: f64| ((md / HOLE_STEP_M).max(0.0) as usize).min(last);
    let (first, end) = (place(from_m), place(to_m));
    let per_m = amount / (to_m - from_m);
    for (step, sum) in hole.iter_mut().enumerate().take(end + 1).skip(first) {
        let top = if step == first { from_m } else { step as f64 * HOLE_STEP_M };
        let bottom = if step == end { to_m } else { (step + 1) as f64 * HOLE_STEP_M };
        *sum += per_m * (bottom - top);
    }
}
