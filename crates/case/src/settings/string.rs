//! `string` in the record of a run.

use serde_json::Value as Json;
use wholestring::string::{Component, DrillString};

use super::fields::Fields;

pub(super) fn string(string: &DrillString) -> Json {
    let components = string.components().iter();
    components.map(|part| Json::from(component(part))).collect()
}

/// Parts that a component does not have (joints, blades, a bend, an eccentricity, a lateral force)
/// are omitted.
fn component(component: &Component) -> Fields {
    Fields::of(component)
        .renamed([("name", "component")])
        .spread("material", "")
        .spread("joints", "joint_")
        .spread("blades", "blade_")
        .spread("bend", "bend_")
        .spread("eccentricity", "eccentricity_")
        .spread("lateral_force", "lateral_force_")
        .renamed([
            ("bend_angle_rad", "bend_rad"),
            ("bend_from_lower_end_m", "bend_at_m"),
            ("eccentricity_offset_m", "eccentricity_m"),
            ("lateral_force_force_N", "lateral_force_N"),
            ("lateral_force_from_lower_end_m", "lateral_force_at_m"),
        ])
        .words(["eccentricity_cavity"])
}
