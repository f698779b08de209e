//! The case with all defaults filled in, for the record of a run.

use serde_json::{Value as Json, json};
use wholestring::{
    dynamics::{ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, Start},
    model::Model,
    operation::Operation,
    outcome::ModelKind,
    string::Component,
    well::{HoleKind, HoleSection, Interpolation, Well},
};
use wholestring_units::UnitSet;

use crate::{case::CaseTable, rig::HoistTable};

/// What the solvers were given, in SI, with units in the names of the keys.
pub(crate) fn settings(
    name: &str,
    units: UnitSet,
    models: &[ModelKind],
    model: &Model,
    operations: &[Operation],
    dynamics: &DynamicsSettings,
    case: &CaseTable,
) -> Json {
    let survey = case.well.get().and_then(|well| well.survey.get());
    json!({
        "name": name,
        "model": models.iter().map(|model| model.name()).collect::<Vec<_>>(),
        "units": units.name(),
        "well": well(&model.well, survey),
        "mud": {
            "density_kg_per_m3": model.mud.density_kg_per_m3,
            "linear_drag_Pa_s": model.mud.linear_drag_Pa_s,
            "drag_coefficient": model.mud.drag_coefficient,
        },
        "string": model.string.components().iter().map(component).collect::<Vec<_>>(),
        "bit": {
            "torque_N_m": operations.first().map(|operation| operation.bit_torque_N_m),
            "rock_stiffness_N_per_m": dynamics.bit.rock_stiffness_N_per_m,
            "lateral_stiffness_N_per_m": dynamics.bit.lateral_stiffness_N_per_m,
        },
        "rig": {
            "block_weight_N": model.rig.block_weight_N,
            "hoist_capacity_N": model.rig.hoist_capacity_N,
            "top_drive_torque_N_m": model.rig.top_drive_torque_N_m,
        },
        "hoist": hoist(dynamics, case.hoist.get()),
        "operation": operation(operations),
        "mesh": { "element_length_m": dynamics.element_length_m },
        "dynamics": run(dynamics, case),
    })
}

fn well(well: &Well, survey: Option<&String>) -> Json {
    let stations = well.path.stations();
    let start = well.path.at(well.path.first_md_m()).position_m;
    json!({
        "survey": survey,
        "stations": {
            "md_m": stations.iter().map(|station| station.md_m).collect::<Vec<_>>(),
            "inclination_rad": stations.iter().map(|station| station.inclination_rad).collect::<Vec<_>>(),
            "azimuth_rad": stations.iter().map(|station| station.azimuth_rad).collect::<Vec<_>>(),
        },
        "path": match well.path.interpolation() {
            Interpolation::Spline => "spline",
            Interpolation::MinimumCurvature => "minimum-curvature",
        },
        "tie_in": { "north_m": start.x, "east_m": start.y, "tvd_m": start.z },
        "hole": well.hole.sections().iter().map(section).collect::<Vec<_>>(),
    })
}

fn section(section: &HoleSection) -> Json {
    json!({
        "kind": match section.kind {
            HoleKind::Casing => "casing",
            HoleKind::Open => "open",
        },
        "from_m": section.from_md_m,
        "to_m": section.to_md_m,
        "diameter_m": section.diameter_m,
        "friction": { "kinetic": section.friction.kinetic, "static": section.friction.at_rest },
        "youngs_modulus_Pa": section.youngs_modulus_Pa,
        "poisson_ratio": section.poisson_ratio,
    })
}

fn component(component: &Component) -> Json {
    json!({
        "component": component.name,
        "length_m": component.length_m,
        "od_m": component.od_m,
        "id_m": component.id_m,
        "joint_od_m": component.joints.map(|joints| joints.od_m),
        "joint_spacing_m": component.joints.map(|joints| joints.spacing_m),
        "mass_per_length_kg_per_m": component.mass_per_length_kg_per_m,
        "density_kg_per_m3": component.material.density_kg_per_m3,
        "youngs_modulus_Pa": component.material.youngs_modulus_Pa,
        "shear_modulus_Pa": component.material.shear_modulus_Pa,
        "yield_strength_Pa": component.yield_strength_Pa,
    })
}

/// The control as solved; `null` leaves it to the operation. The autodriller's numbers stand also
/// where it is not the control that was chosen: an operation on bottom takes it.
fn hoist(dynamics: &DynamicsSettings, table: Option<&HoistTable>) -> Json {
    let number = |value: Option<&f64>| value.copied();
    json!({
        "control": dynamics.hoist_control.map(|control| match control {
            HoistControl::Autodriller { .. } => "autodriller",
            HoistControl::BlockVelocity(_) => "block-velocity",
            HoistControl::HookLoad(_) => "hook-load",
        }),
        "gain_m_per_s_per_N": number(table.and_then(|table| table.gain.get())),
        "filter_s": number(table.and_then(|table| table.filter.get())),
        "block_velocity_m_per_s": number(table.and_then(|table| table.block_velocity.get())),
        "hook_load_N": number(table.and_then(|table| table.hook_load.get())),
        "stiffness_N_per_m": dynamics.hoist_line.stiffness_N_per_m,
        "damping_N_s_per_m": dynamics.hoist_line.damping_N_s_per_m,
    })
}

fn operation(operations: &[Operation]) -> Json {
    let first = operations.first();
    json!({
        "kind": operations.iter().map(|operation| operation.kind.name()).collect::<Vec<_>>(),
        "bit_depth_m": first.map(|operation| operation.bit_depth_m),
        "rotary_speed_rad_per_s": first.map(|operation| operation.rotary_speed_rad_per_s),
        "wob_N": first.map(|operation| operation.weight_on_bit_N),
        "rop_m_per_s": first.map(|operation| operation.rate_of_penetration_m_per_s),
        "trip_speed_m_per_s": first.map(|operation| operation.trip_speed_m_per_s),
    })
}

fn run(dynamics: &DynamicsSettings, case: &CaseTable) -> Json {
    let table = case.dynamics.get();
    let mut run = json!({
        "duration_s": dynamics.duration_s,
        "settle_s": dynamics.settle_s,
        "start": match dynamics.start {
            Start::Prepared => "prepared",
            Start::Centred => "centred",
        },
        "friction_law": match dynamics.friction_law {
            FrictionLaw::Vector => "vector",
            FrictionLaw::Independent => "independent",
        },
        "damping": {
            "mass_per_s": dynamics.damping.mass_per_s,
            "stiffness_s": dynamics.damping.stiffness_s,
        },
        "sample_interval_s": dynamics.sample_interval_s,
        "checkpoint_interval_s": table.and_then(|table| table.checkpoint_interval.get()),
        "seed": dynamics.seed,
    });
    match dynamics.contact_law {
        ContactLaw::Hertz {
            dissipation_s_per_m,
        } => {
            run["contact_law"] = json!("hertz");
            run["hertz_dissipation_s_per_m"] = json!(dissipation_s_per_m);
        }
        ContactLaw::Linear {
            stiffness_N_per_m,
            damping_ratio,
        } => {
            run["contact_law"] = json!("linear");
            run["contact_stiffness_N_per_m"] = json!(stiffness_N_per_m);
            run["contact_damping_ratio"] = json!(damping_ratio);
        }
    }
    run
}
