//! A curve of a figure.

use wholestring_study::{Quantity, Statistic};

use super::results::Series;

/// A curve with all properties that distinguish it from the others.
pub(super) struct Curve {
    pub(super) series: Series,
    /// Values of the keys that are not on the axis.
    pub(super) values: Vec<(String, String)>,
    /// The column, and the operations applied to it.
    pub(super) quantity: Quantity,
    pub(super) statistic: Option<Statistic>,
    /// Time, s, or depth, m, of the curve.
    pub(super) at: Option<f64>,
    /// Points, SI; NaN for a missing value.
    pub(super) points: Vec<(f64, f64)>,
    /// Points whose case has an error.
    pub(super) errors: Vec<(f64, f64)>,
    /// Additional data of a map; `None` for a curve.
    pub(super) map: Option<MapData>,
}

/// Additional data of a map. The points of a map are times and values, row after row in time.
pub(super) struct MapData {
    /// Depth of each point, m.
    pub(super) depths_m: Vec<f64>,
    /// Start of the first row, s.
    pub(super) from_s: f64,
    /// Start of the window of the statistics, s.
    pub(super) window_from_s: f64,
    /// Depths of the casing shoes, m.
    pub(super) shoes_m: Vec<f64>,
}

/// Value of the quantity, without its sign if requested.
pub(super) fn signed(quantity: &Quantity, value: f64) -> f64 {
    if quantity.magnitude { value.abs() } else { value }
}

/// Whether a time is in the window, if there is one.
pub(super) fn within(window_s: Option<[f64; 2]>, time_s: f64) -> bool {
    // Times of samples are sums, so the bounds include their rounding.
    window_s.is_none_or(|[from, to]| (from - 1e-6..=to + 1e-6).contains(&time_s))
}

/// Rank of a series' method, the most detailed first; the others are drawn dashed.
pub(super) fn rank(series: &Series) -> usize {
    series.1.rank()
}
