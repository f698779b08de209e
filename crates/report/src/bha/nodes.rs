//! Columns of the string along its axis, and a quantity that an analysis varies.

use wholestring_results::{BhaFound, BhaSummary, BhaVaried, Table};

/// Columns of `bha.parquet`, SI; one that is not known is not a number. Nodes are ordered from the
/// bit up.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Nodes {
    /// Distances from the bit, m.
    pub(super) from_bit_m: Vec<f64>,
    /// Radius of the hole, m.
    pub(super) hole_radius_m: Vec<f64>,
    /// Offset of the string's axis from the hole's, m.
    pub(super) offset_m: [Vec<f64>; 2],
    /// Bending moment, N·m.
    pub(super) moment_N_m: [Vec<f64>; 2],
    /// Bending stress, Pa.
    pub(super) bending_stress_Pa: Vec<f64>,
    /// Von Mises stress, Pa.
    pub(super) von_mises_stress_Pa: Vec<f64>,
}

impl Nodes {
    /// The columns of the table.
    pub(super) fn new(table: &Table) -> Self {
        let column = |name| table.values(name);
        Self {
            from_bit_m: column("from_bit_m"),
            hole_radius_m: column("hole_radius_m"),
            offset_m: ["offset_high_m", "offset_right_m"].map(column),
            moment_N_m: ["bending_moment_high_N_m", "bending_moment_right_N_m"].map(column),
            bending_stress_Pa: column("bending_stress_Pa"),
            von_mises_stress_Pa: column("von_mises_stress_Pa"),
        }
    }
}

// A quantity that an analysis of an assembly varies.

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
