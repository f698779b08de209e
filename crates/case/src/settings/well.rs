//! `well`, `string`, `hoist` and `top_drive` in the record of a run.

use serde_json::{Value as Json, json};
use wholestring::{
    dynamics::{DynamicsSettings, HoistControl, TopDriveSettings},
    operation::Operation,
    string::{Component, DrillString},
    well::{HoleSection, Roughness, Station, Well},
};

use super::fields::{Fields, json, word};
use crate::rig::TUNED_LIFT;

pub(super) fn well(well: &Well, survey: Option<&String>, tortuosity: Option<Json>) -> Json {
    let column = |value: fn(&Station) -> f64| -> Vec<f64> {
        well.path.stations().iter().map(value).collect()
    };
    let start = well.path.at(well.path.first_md_m()).position_m;
    let sections = well.hole.sections().iter();
    json!({
        "survey": survey,
        "stations": {
            "md_m": column(|station| station.md_m),
            "inclination_rad": column(|station| station.inclination_rad),
            "azimuth_rad": column(|station| station.azimuth_rad),
        },
        "path": word(&well.path.interpolation()),
        "tie_in": { "north_m": start.x, "east_m": start.y, "tvd_m": start.z },
        "tortuosity": tortuosity,
        "roughness": well.hole.roughness().map(|rough| Json::from(roughness(rough))),
        "hole": sections.map(|part| Json::from(section(part))).collect::<Vec<_>>(),
    })
}

fn roughness(roughness: &Roughness) -> Fields {
    Fields::of(roughness).renamed([
        ("radius_rms_m", "rms_m"),
        ("tortuosity_rms_m", "tortuosity_m"),
        ("shortest_m", "shortest_wavelength_m"),
        ("longest_m", "longest_wavelength_m"),
    ])
}

fn section(section: &HoleSection) -> Fields {
    let friction = &section.friction;
    // The engine stores it as a part of the kinetic one.
    let around = friction.kinetic * friction.around;
    let friction =
        Fields::of(friction).renamed([("at_rest", "static")]).with("around", json(&around));
    Fields::of(section)
        .words(["kind"])
        .renamed([("from_md_m", "from_m"), ("to_md_m", "to_m")])
        .with("friction", friction)
}

// `string` in the record of a run.

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

// `hoist` and `top_drive` in the record of a run.

/// The control by its word, as chosen; `null` leaves it to the operation. The numbers of a control
/// that is never active are `null`.
pub(super) fn hoist(
    dynamics: &DynamicsSettings,
    operations: &[Operation],
    control: Option<&str>,
) -> Fields {
    let tuned = control == Some(TUNED_LIFT);
    let on_bottom = operations.iter().any(|one| one.kind.on_bottom());
    let by_itself = dynamics.hoist_control.is_none() && !tuned && on_bottom;
    let automatic = by_itself
        || dynamics.hoist_control == Some(HoistControl::Autodriller)
        || dynamics.schedule.holds_a_weight();
    let autodriller = Fields::of(&dynamics.autodriller);
    let (velocity, load) = match dynamics.hoist_control {
        Some(HoistControl::BlockVelocity(velocity)) => (Some(velocity), None),
        Some(HoistControl::HookLoad(load)) => (None, Some(load)),
        Some(HoistControl::Autodriller) | None => (None, None),
    };
    Fields::of(&dynamics.hoist_line)
        .renamed([("block_mass_kg", "mass_kg")])
        .and(if automatic { autodriller } else { autodriller.nulled() })
        .with("control", control)
        .with("block_velocity_m_per_s", velocity)
        .with("hook_load_N", load)
        .with("tolerance", tuned.then_some(dynamics.lift_tolerance))
}

/// The settings of the drive in a run; values that it derives from the string are `null`.
pub(super) fn top_drive(drive: &TopDriveSettings) -> Fields {
    Fields::tagged("control", drive).spread_variant("controller", "control")
}
