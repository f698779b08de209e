//! A quantity that an analysis of an assembly varies.

use wholestring_results::{BhaFound, BhaSummary, BhaVaried};

/// The bit against a varied quantity.
pub(crate) struct Varied<'a> {
    /// Name of its picture.
    pub(crate) name: &'static str,
    /// The varied quantity, as shown to users.
    pub(crate) title: &'static str,
    /// Its dimension.
    pub(super) dimension: &'static str,
    /// Each value with an equilibrium, SI.
    pub(super) points: Vec<(f64, BhaFound)>,
    /// The value that the case has, SI.
    pub(super) now: Option<f64>,
    /// Values at which the side force towards the high side is zero, SI.
    pub(super) zeros: &'a [f64],
}

impl<'a> Varied<'a> {
    /// Results of a variation; `None` if nothing was varied.
    pub(super) fn new(summary: &'a BhaSummary, varied: BhaVaried) -> Option<Self> {
        let (title, dimension, now, zeros): (_, _, _, &[f64]) = match varied {
            BhaVaried::Toolface => ("Tool face", "angle", summary.toolface_rad, &[]),
            BhaVaried::Weight => (
                "Weight on bit",
                "force",
                Some(summary.weight_on_bit_N),
                &summary.holding_weights_N,
            ),
            BhaVaried::Inclination if summary.build_rate_rad_per_m != 0.0 => (
                "Inclination at the bit of a hole that builds evenly",
                "angle",
                None,
                &summary.holding_inclinations_rad,
            ),
            BhaVaried::Inclination => {
                ("Inclination of a straight hole", "angle", None, &summary.holding_inclinations_rad)
            }
        };
        let points = summary.sweep.iter().filter(|point| point.varied == varied);
        let points: Vec<_> =
            points.filter_map(|point| Some((point.value(), point.found?))).collect();
        let name = varied.name();
        (!points.is_empty()).then_some(Self { name, title, dimension, points, now, zeros })
    }
}
