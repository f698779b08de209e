//! Key facts of an assembly: its tendency in sentences, and its numbers as text.

use wholestring_results::{BhaSummary, BhaVaried};
use wholestring_units::{Dimension, UnitSet, without_trailing_zeros};

use crate::{Cell, Fact};

/// Key facts of the assembly.
pub(super) fn facts(summary: &BhaSummary) -> Vec<Fact> {
    let state = &summary.state;
    let [high_N, right_N] = state.side_force_N;
    let [up_rad, aside_rad] = state.tilt_rad;
    let mut facts = vec![
        Fact::new("Operation", Cell::Text(summary.operation.words().to_owned())),
        Fact::new("Bit depth", Cell::quantity(summary.bit_depth_m, "length")),
        Fact::new("Inclination", Cell::quantity(summary.inclination_rad, "angle")),
        Fact::new("Weight on bit", Cell::quantity(summary.weight_on_bit_N, "force")),
    ];
    if let Some(toolface_rad) = summary.toolface_rad {
        facts.push(Fact::new("Tool face", Cell::quantity(toolface_rad, "angle")));
    }
    facts.extend([
        Fact::new("Side force, high side positive", Cell::quantity(high_N, "force")),
        Fact::new("Side force to the right", Cell::quantity(right_N, "force")),
        Fact::new("Tilt of the bit, high side positive", Cell::quantity(up_rad, "angle")),
        Fact::new("Tilt of the bit to the right", Cell::quantity(aside_rad, "angle")),
    ]);
    if let Some(sag) = state.sag.first() {
        let correction = Cell::quantity(sag.inclination_rad, "angle");
        facts.push(Fact::new("Sag correction of the inclination", correction));
    }
    facts
}

// Tendency of an assembly to change the inclination of the hole, in sentences.

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

// Numbers of a static BHA analysis as text.

/// Four digits of a quantity, with its unit.
pub fn bha_quantity(si: f64, dimension: Dimension, units: UnitSet) -> String {
    let number = bha_number(si, dimension, units);
    format!("{} {}", without_trailing_zeros(&number), dimension.unit_in(units).symbol)
}

/// A number in the chosen unit, with four digits or to the third decimal; a length to the second
/// decimal at least, because contacts are identified by their depth.
pub fn bha_number(si: f64, dimension: Dimension, units: UnitSet) -> String {
    let value = dimension.unit_in(units).from_si(si);
    let digits = match value.abs() {
        size if size >= 10.0 && dimension == Dimension::Length => 2,
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        _ => 3,
    };
    let text = format!("{value:.digits$}");
    if text.trim_matches(['-', '0', '.']).is_empty() { "0".to_owned() } else { text }
}
