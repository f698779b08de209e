//! Contents of the page of a bit that was tested alone on the rock, and its pictures.

mod figures;

pub use figures::bit_test_plots;

use crate::{BottomPicture, Cell, PageHead, PageTable, Place};

/// A bit test as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct BitTest {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// Uniaxial compressive strength of the rock, Pa.
    pub strength_Pa: f64,
    /// Radius of the bit, m.
    pub radius_m: f64,
    /// Slope (m) and offset (N·m) of the straight line of torque over weight through all points;
    /// `None` for fewer than two weights.
    pub torque_by_weight: Option<[f64; 2]>,
    /// The points, in any order.
    pub points: Vec<BitTestPoint>,
    /// Reason why points are missing; `None` where none is missing.
    pub message: Option<String>,
    /// Tables of inputs.
    pub page_tables: Vec<PageTable>,
}

/// One weight at one speed. A number that is not known is not finite.
#[derive(Debug, Clone, PartialEq)]
pub struct BitTestPoint {
    /// Mean weight on bit, N.
    pub weight_N: f64,
    /// Its standard deviation, N.
    pub weight_std_N: f64,
    /// Rotary speed as set, rad/s.
    pub rotary_rad_per_s: f64,
    /// Mean rate of penetration, m/s.
    pub rate_m_per_s: f64,
    /// Mean torque, N·m.
    pub torque_N_m: f64,
    /// Its standard deviation, N·m.
    pub torque_std_N_m: f64,
    /// Depth of cut per revolution, m.
    pub depth_of_cut_m: f64,
    /// Work per broken volume, Pa.
    pub specific_energy_Pa: f64,
    /// The bottom of the hole at its end.
    pub bottom: Option<BottomPicture>,
}

impl BitTest {
    /// The points by speed, then by weight.
    pub(crate) fn sorted(&self) -> Vec<&BitTestPoint> {
        let mut points: Vec<&BitTestPoint> = self.points.iter().collect();
        points.sort_by(|a, b| {
            let speeds = a.rotary_rad_per_s.total_cmp(&b.rotary_rad_per_s);
            speeds.then(a.weight_N.total_cmp(&b.weight_N))
        });
        points
    }

    /// All numbers, a row for each point.
    pub(crate) fn page_table(&self) -> PageTable {
        let heads = [
            "Rotary speed",
            "Weight on bit",
            "Rate of penetration",
            "Depth of cut",
            "Torque",
            "Torque over weight and radius",
            "Specific energy",
        ];
        let mean = |value: f64, std: f64, dimension: &str| match Cell::quantity(value, dimension) {
            Cell::Quantity { value, dimension, .. } => {
                Cell::Quantity { value, dimension, std: Some(std).filter(|std| std.is_finite()) }
            }
            other => other,
        };
        let row = |point: &&BitTestPoint| {
            vec![
                Cell::quantity(point.rotary_rad_per_s, "rotary speed"),
                mean(point.weight_N, point.weight_std_N, "force"),
                Cell::quantity(point.rate_m_per_s, "rate of penetration"),
                Cell::quantity(point.depth_of_cut_m, "diameter"),
                mean(point.torque_N_m, point.torque_std_N_m, "torque"),
                Cell::quantity(point.torque_N_m / (point.weight_N * self.radius_m), "ratio"),
                Cell::quantity(point.specific_energy_Pa, "specific energy"),
            ]
        };
        PageTable {
            place: Place::Cases,
            title: "All points: mean ± standard deviation within a point".into(),
            heads: heads.map(String::from).to_vec(),
            rows: self.sorted().iter().map(row).collect(),
        }
    }
}

#[cfg(test)]
mod tests;
