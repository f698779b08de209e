//! What a page tells of a bit that was tested alone on the rock, and its pictures.

mod figures;

use std::collections::BTreeMap;

use crate::{BottomPicture, Cell, DisplayUnit, Fact, Place, Plot, Sheet};

/// A bit test as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct BitTest {
    /// Name and version of the program.
    pub program: String,
    /// Name of the test.
    pub title: String,
    /// Units that the page opens with: `si`, `metric` or `field`.
    pub units: String,
    /// By dimension: its unit in SI, metric and field units.
    pub dimensions: BTreeMap<String, [DisplayUnit; 3]>,
    /// Bit and rock in a few facts.
    pub asked: Vec<Fact>,
    /// Uniaxial compressive strength of the rock, Pa.
    pub strength_Pa: f64,
    /// Radius of the bit, m.
    pub radius_m: f64,
    /// What was measured, in any order.
    pub points: Vec<BitTestPoint>,
    /// Why points are missing; nothing where none is.
    pub message: Option<String>,
    /// Tables of inputs.
    pub sheets: Vec<Sheet>,
}

/// One weight at one speed. A number that is not known is not finite.
#[derive(Debug, Clone, PartialEq)]
pub struct BitTestPoint {
    /// Mean weight on bit, N.
    pub weight_N: f64,
    /// Its standard deviation, N.
    pub weight_std_N: f64,
    /// Rotary speed as it was set, rad/s.
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

/// Every picture of a bit test, in a set of units (`si`, `metric` or `field`): `drill-off` (rate of penetration and torque
/// against weight), `specific-energy` (against depth of cut) and `bottom-hole`; none where no point is there.
pub fn bit_test_plots(test: &BitTest, units: &str) -> Vec<Plot> {
    figures::plots(test, units)
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

    /// Slope and offset, m and N·m, of the straight line through torque over weight that leaves the least squares; none of
    /// fewer than two weights.
    fn torque_fit(&self) -> Option<(f64, f64)> {
        let points = self.points.iter().map(|of| (of.weight_N, of.torque_N_m));
        let points: Vec<(f64, f64)> = points.filter(|(x, y)| (x + y).is_finite()).collect();
        let count = points.len() as f64;
        let mean_x = points.iter().map(|(x, _)| x).sum::<f64>() / count;
        let mean_y = points.iter().map(|(_, y)| y).sum::<f64>() / count;
        let (mut xx, mut xy) = (0.0, 0.0);
        for (x, y) in &points {
            xx += (x - mean_x).powi(2);
            xy += (x - mean_x) * (y - mean_y);
        }
        // Weights that differ by rounding make no slope.
        let apart = xx > count * (1e-6 * mean_x).powi(2);
        let slope = xy / xx;
        apart.then_some((slope, mean_y - slope * mean_x))
    }

    /// All numbers, a row for each point.
    pub(crate) fn sheet(&self) -> Sheet {
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
            Cell::Quantity {
                value, dimension, ..
            } => Cell::Quantity {
                value,
                dimension,
                std: Some(std).filter(|std| std.is_finite()),
            },
            other => other,
        };
        let row = |of: &&BitTestPoint| {
            vec![
                Cell::quantity(of.rotary_rad_per_s, "rotary speed"),
                mean(of.weight_N, of.weight_std_N, "force"),
                Cell::quantity(of.rate_m_per_s, "rate of penetration"),
                Cell::quantity(of.depth_of_cut_m, "diameter"),
                mean(of.torque_N_m, of.torque_std_N_m, "torque"),
                Cell::quantity(of.torque_N_m / (of.weight_N * self.radius_m), "ratio"),
                Cell::quantity(of.specific_energy_Pa, "specific energy"),
            ]
        };
        Sheet {
            place: Place::Cases,
            title: "All points: mean ± standard deviation within a point".into(),
            heads: heads.map(String::from).to_vec(),
            rows: self.sorted().iter().map(row).collect(),
        }
    }
}

#[cfg(test)]
mod tests;
