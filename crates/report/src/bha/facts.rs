//! Key facts of an assembly.

use wholestring_results::BhaSummary;

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
