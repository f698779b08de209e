//! Columns of the string along its axis.

use wholestring_results::Table;

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
