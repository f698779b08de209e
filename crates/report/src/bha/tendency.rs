//! Tendency of an assembly to change the inclination of the hole, in sentences.

use wholestring_results::{BhaSummary, BhaVaried};
use wholestring_units::{Dimension, UnitSet};

use super::bha_quantity;

/// Inclinations at which the assembly holds, or that it builds or drops at all of them, and the mean
/// side force of all tool faces; empty where neither was computed.
pub fn bha_tendency(summary: &BhaSummary, units: UnitSet) -> Vec<String> {
    let mut sentences = Vec::new();
    let angles = summary.holding_inclinations_rad.iter();
    let angles: Vec<String> =
        angles.map(|rad| bha_quantity(*rad, Dimension::Angle, units)).collect();
    let varied = summary.sweep.iter().filter(|point| point.varied == BhaVaried::Inclination);
    let first = varied.clone().find_map(|point| point.found);
    if !angles.is_empty() {
        sentences.push(format!("It holds at an inclination of {}", angles.join(", ")));
    } else if let Some(first) = first {
        let word = if first.side_force_N[0] > 0.0 { "builds" } else { "drops" };
        sentences.push(format!("It {word} at every inclination that was tried"));
    }
    if let Some([high_N, right_N]) = summary.mean_side_force_N {
        let force = |newton: f64| bha_quantity(newton, Dimension::Force, units);
        sentences.push(format!(
            "Mean of all tool faces: {} to the high side, {} to the right",
            force(high_N),
            force(right_N)
        ));
    }
    sentences
}
