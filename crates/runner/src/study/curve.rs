//! A curve of a figure.

use wholestring_study::{Quantity, Statistic};

use super::results::Series;

/// A curve with everything that distinguishes it from the others.
pub(super) struct Curve {
    pub(super) series: Series,
    /// Values of the keys that are not on the axis.
    pub(super) values: Vec<(String, String)>,
    /// The column, and what is made of it.
    pub(super) quantity: Quantity,
    pub(super) statistic: Option<Statistic>,
    /// The time, s, or depth, m, that it was taken at.
    pub(super) at: Option<f64>,
    /// Its points, SI; NaN where there is none.
    pub(super) points: Vec<(f64, f64)>,
    /// Those of them whose case has an error.
    pub(super) errors: Vec<(f64, f64)>,
    /// What else a map needs; none of a curve.
    pub(super) map: Option<MapData>,
}

/// Beside the points of a map, which are times and values, row after row in time.
pub(super) struct MapData {
    /// Depth of each point, m.
    pub(super) depths_m: Vec<f64>,
    /// When the first row begins, s.
    pub(super) from_s: f64,
    /// When the window of the statistics begins, s.
    pub(super) window_from_s: f64,
    /// Where the shoes of the casing stand, m.
    pub(super) shoes_m: Vec<f64>,
}

/// A value as the quantity has it: without its sign where that is requested.
pub(super) fn signed(quantity: &Quantity, value: f64) -> f64 {
    if quantity.magnitude { value.abs() } else { value }
}

/// Whether a time is in the window, where there is one.
pub(super) fn within(window_s: Option<[f64; 2]>, time_s: f64) -> bool {
    // Samples are summed times: a bound that is meant to be one takes it.
    window_s.is_none_or(|[from, to]| (from - 1e-6..=to + 1e-6).contains(&time_s))
}

/// The place of a series' method among all, the most detailed first: the others are drawn dashed
/// beside it.
pub(super) fn rank(series: &Series) -> usize {
    series.1.rank()
}
