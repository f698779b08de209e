//! The case with all defaults filled in, for the record of a run.

use serde_json::{Value as Json, json};
use wholestring::{
    dynamics::{
        Band, BitLaw, BitTable, ContactLaw, Cutters, DynamicsSettings, Excitation, FrictionLaw,
        HoistControl, HoistSetPoint, Motor, Precision, Schedule, ScheduleStep, SpeedController,
        Start, StartTension, TablePoint, TopDriveSettings,
    },
    model::Model,
    mud::Rheology,
    operation::Operation,
    outcome::ModelKind,
    string::{Cavity, Component},
    well::{HoleKind, HoleSection, Interpolation, Well},
};
use wholestring_units::UnitSet;

use crate::{
    case_table::CaseTable,
    rig::{HoistTable, TUNED_LIFT},
    settle::AUTO,
};

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
            "rheology": model.mud.rheology.map(rheology),
        },
        "string": model.string.components().iter().map(component).collect::<Vec<_>>(),
        "bit": bit(dynamics, operations),
        "rig": {
            "block_weight_N": model.rig.block_weight_N,
            "hoist_capacity_N": model.rig.hoist_capacity_N,
            "top_drive_torque_N_m": model.rig.top_drive_torque_N_m,
        },
        "hoist": hoist(dynamics, operations, case.hoist.get()),
        "top_drive": top_drive(&dynamics.top_drive),
        "operation": operation(operations, &dynamics.schedule),
        "mesh": { "element_length_m": dynamics.element_length_m },
        "dynamics": run(dynamics, case),
    })
}

fn rheology(rheology: Rheology) -> Json {
    match rheology {
        Rheology::Newtonian { viscosity_Pa_s } => json!({
            "law": "newtonian",
            "viscosity_Pa_s": viscosity_Pa_s,
        }),
        Rheology::Bingham {
            plastic_viscosity_Pa_s,
            yield_point_Pa,
        } => json!({
            "law": "bingham",
            "plastic_viscosity_Pa_s": plastic_viscosity_Pa_s,
            "yield_point_Pa": yield_point_Pa,
        }),
        Rheology::PowerLaw {
            consistency_Pa_s_n,
            flow_index,
        } => json!({
            "law": "power-law",
            "consistency_Pa_s_n": consistency_Pa_s_n,
            "flow_index": flow_index,
        }),
    }
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
        "roughness": well.hole.roughness().map(|roughness| json!({
            "rms_m": roughness.radius_rms_m,
            "tortuosity_m": roughness.tortuosity_rms_m,
            "shortest_wavelength_m": roughness.shortest_m,
            "longest_wavelength_m": roughness.longest_m,
            "seed": roughness.seed,
        })),
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
        "friction": {
            "kinetic": section.friction.kinetic,
            "static": section.friction.at_rest,
            "around": section.friction.kinetic * section.friction.around,
        },
        "youngs_modulus_Pa": section.youngs_modulus_Pa,
        "poisson_ratio": section.poisson_ratio,
        "roughness": section.roughness,
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
        "blade_od_m": component.blades.map(|blades| blades.od_m),
        "blade_length_m": component.blades.map(|blades| blades.length_m),
        "mass_per_length_kg_per_m": component.mass_per_length_kg_per_m,
        "density_kg_per_m3": component.material.density_kg_per_m3,
        "youngs_modulus_Pa": component.material.youngs_modulus_Pa,
        "shear_modulus_Pa": component.material.shear_modulus_Pa,
        "yield_strength_Pa": component.yield_strength_Pa,
        "bend_rad": component.bend.map(|bend| bend.angle_rad),
        "bend_at_m": component.bend.map(|bend| bend.from_lower_end_m),
        "bend_toolface_rad": component.bend.map(|bend| bend.toolface_rad),
        "eccentricity_m": component.eccentricity.map(|of| of.offset_m),
        "eccentricity_phase_rad": component.eccentricity.map(|of| of.phase_rad),
        "eccentricity_cavity": component.eccentricity.map(|of| match of.cavity {
            Cavity::Mud => "mud",
            Cavity::Sealed => "sealed",
        }),
    })
}

/// The bit, with the keys of its law alone.
fn bit(dynamics: &DynamicsSettings, operations: &[Operation]) -> Json {
    let mut bit = json!({
        "torque_N_m": operations.first().map(|operation| operation.bit_torque_N_m),
        "lateral_stiffness_N_per_m": dynamics.bit.lateral_stiffness_N_per_m,
        "steerability": dynamics.bit.steerability,
    });
    match dynamics.bit.motor {
        Motor::Speed(speed) => bit["motor_speed_rad_per_s"] = json!(speed),
        Motor::Displacement(motor) => {
            bit["motor"] = json!({
                "displacement_m3": motor.displacement_m3,
                "max_differential_pressure_Pa": motor.max_pressure_Pa,
                "slip": motor.slip,
                "efficiency": motor.efficiency,
                "stall_torque_N_m": motor.stall_torque_N_m,
                "rated_flow_m3_per_s": motor.rated_flow_m3_per_s,
            });
        }
    }
    let (law, own, front) = match &dynamics.bit.law {
        BitLaw::Rate(law) => (
            "rate",
            json!({}),
            Some((law.rock_stiffness_N_per_m, law.excitation)),
        ),
        BitLaw::Regenerative(law) => {
            let mut own = cutters(&law.cutters);
            own["blades"] = json!(law.blades);
            ("regenerative", own, None)
        }
        BitLaw::DetournayDefourny(law) => {
            let mut own = cutters(&law.cutters);
            own["full_contact_depth_m"] = json!(law.full_contact_depth_m);
            own["cleaning_limit_m"] = json!(law.cleaning_limit_m);
            let front = (law.rock_stiffness_N_per_m, law.excitation);
            ("detournay-defourny", own, Some(front))
        }
        BitLaw::Table(law) => (
            "table",
            json!({ "table": points(&law.table) }),
            Some((law.rock_stiffness_N_per_m, law.excitation)),
        ),
        BitLaw::Rock(_) => ("rock", json!({}), None),
    };
    bit["law"] = json!(law);
    if let Some((stiffness, shaken)) = front {
        bit["rock_stiffness_N_per_m"] = json!(stiffness);
        bit["excitation"] = shaken.map_or(Json::Null, excitation);
    }
    if let (Json::Object(bit), Json::Object(own)) = (&mut bit, own) {
        bit.extend(own);
    }
    bit
}

fn excitation(shaken: Excitation) -> Json {
    let (waves, frequency) = match shaken.band {
        Band::PerRevolution(waves) => (Some(waves), None),
        Band::PerSecond(frequency) => (None, Some(frequency)),
    };
    json!({
        "lobes": shaken.lobes,
        "amplitude_m": shaken.amplitude_m,
        "roughness_m": shaken.roughness_m,
        "torque_fluctuation": shaken.torque_fluctuation,
        "waves": waves,
        "frequency_per_s": frequency,
    })
}

fn cutters(cutters: &Cutters) -> Json {
    json!({
        "radius_m": cutters.radius_m,
        "core_radius_m": cutters.core_radius_m,
        "intrinsic_specific_energy_Pa": cutters.intrinsic_specific_energy_Pa,
        "cutter_inclination": cutters.cutter_inclination,
        "wear_flat_m": cutters.wear_flat_m,
        "contact_strength_Pa": cutters.contact_strength_Pa,
        "bit_geometry": cutters.bit_geometry,
        "friction": cutters.friction,
    })
}

/// What was measured, column by column.
fn points(table: &BitTable) -> Json {
    let points = table.points();
    let column = |of: fn(&TablePoint) -> f64| points.iter().map(of).collect::<Vec<_>>();
    let spread =
        |of: fn(&TablePoint) -> Option<f64>| points.iter().map(of).collect::<Option<Vec<_>>>();
    json!({
        "weight_on_bit_N": column(|p| p.weight_on_bit_N),
        "rotary_speed_rad_per_s": column(|p| p.rotary_speed_rad_per_s),
        "rate_of_penetration_m_per_s": column(|p| p.rate_of_penetration_m_per_s),
        "torque_N_m": column(|p| p.torque_N_m),
        "torque_std_N_m": spread(|p| p.torque_std_N_m),
        "weight_on_bit_std_N": spread(|p| p.weight_on_bit_std_N),
    })
}

/// The control as chosen; `null` leaves it to the operation. The numbers of a control that nothing puts in control are
/// `null`.
fn hoist(
    dynamics: &DynamicsSettings,
    operations: &[Operation],
    table: Option<&HoistTable>,
) -> Json {
    let control = table.and_then(HoistTable::control_word);
    let tuned = control == Some(TUNED_LIFT);
    let on_bottom = operations.iter().any(|one| one.kind.on_bottom());
    let by_itself = dynamics.hoist_control.is_none() && !tuned && on_bottom;
    let automatic = by_itself
        || dynamics.hoist_control == Some(HoistControl::Autodriller)
        || dynamics.schedule.holds_a_weight();
    let autodriller = automatic.then_some(dynamics.autodriller);
    json!({
        "control": control,
        "gain_m_per_s_per_N": autodriller.map(|of| of.gain_m_per_s_per_N),
        "integral_time_s": autodriller.map(|of| of.integral_time_s),
        "filter_s": autodriller.map(|of| of.filter_s),
        "min_speed_m_per_s": autodriller.map(|of| of.min_speed_m_per_s),
        "max_speed_m_per_s": autodriller.map(|of| of.max_speed_m_per_s),
        "block_velocity_m_per_s": match dynamics.hoist_control {
            Some(HoistControl::BlockVelocity(velocity)) => Some(velocity),
            _ => None,
        },
        "hook_load_N": match dynamics.hoist_control {
            Some(HoistControl::HookLoad(load)) => Some(load),
            _ => None,
        },
        "tolerance": tuned.then_some(dynamics.lift_tolerance),
        "stiffness_N_per_m": dynamics.hoist_line.stiffness_N_per_m,
        "damping_N_s_per_m": dynamics.hoist_line.damping_N_s_per_m,
        "mass_kg": dynamics.hoist_line.block_mass_kg,
    })
}

/// The drive as it runs; what it finds by itself from the string is `null`.
fn top_drive(drive: &TopDriveSettings) -> Json {
    let TopDriveSettings::Driven {
        inertia_kg_m2,
        controller,
        torque_limit_N_m,
    } = *drive
    else {
        return json!({ "control": "constant" });
    };
    let mut json = match controller {
        SpeedController::Pi {
            proportional_N_m_s,
            integral_N_m,
        } => json!({
            "control": "pi",
            "proportional_N_m_s": proportional_N_m_s,
            "integral_N_m": integral_N_m,
        }),
        SpeedController::SoftTorque {
            impedance_ratio,
            frequency_Hz,
        } => json!({
            "control": "soft-torque",
            "impedance_ratio": impedance_ratio,
            "frequency_Hz": frequency_Hz,
        }),
        SpeedController::ZTorque {
            impedance_ratio,
            frequency_Hz,
            proportional_N_m_s,
            integral_N_m,
        } => json!({
            "control": "z-torque",
            "impedance_ratio": impedance_ratio,
            "frequency_Hz": frequency_Hz,
            "proportional_N_m_s": proportional_N_m_s,
            "integral_N_m": integral_N_m,
        }),
    };
    json["inertia_kg_m2"] = json!(inertia_kg_m2);
    json["torque_limit_N_m"] = json!(torque_limit_N_m);
    json
}

/// The lines of a schedule; what a line does not set is `null`.
fn schedule(schedule: &Schedule) -> Json {
    let line = |step: &ScheduleStep| {
        let (velocity, weight) = match step.hoist {
            Some(HoistSetPoint::BlockVelocity(velocity)) => (Some(velocity), None),
            Some(HoistSetPoint::WeightOnBit(weight)) => (None, Some(weight)),
            None => (None, None),
        };
        json!({
            "at_s": step.at_s,
            "ramp_s": step.ramp_s,
            "rotary_speed_rad_per_s": step.rotary_speed_rad_per_s,
            "block_velocity_m_per_s": velocity,
            "wob_N": weight,
            "flow_rate_m3_per_s": step.flow_rate_m3_per_s,
            "note": step.note,
        })
    };
    schedule.steps.iter().map(line).collect()
}

fn operation(operations: &[Operation], plan: &Schedule) -> Json {
    let first = operations.first();
    json!({
        "kind": operations.iter().map(|operation| operation.kind.name()).collect::<Vec<_>>(),
        "bit_depth_m": first.map(|operation| operation.bit_depth_m),
        "rotary_speed_rad_per_s": first.map(|operation| operation.rotary_speed_rad_per_s),
        "wob_N": first.map(|operation| operation.weight_on_bit_N),
        "rop_m_per_s": first.map(|operation| operation.rate_of_penetration_m_per_s),
        "trip_speed_m_per_s": first.map(|operation| operation.trip_speed_m_per_s),
        "schedule": schedule(plan),
        "flow_rate_m3_per_s": first.map(|operation| operation.flow_rate_m3_per_s),
        "bit_pressure_drop_Pa": first.map(|operation| operation.bit_pressure_drop_Pa),
    })
}

fn run(dynamics: &DynamicsSettings, case: &CaseTable) -> Json {
    let table = case.dynamics.get();
    let mut run = json!({
        "duration_s": dynamics.duration_s,
        // A word where the run finds it: what it was stands in the numerics of each operation.
        "settle_s": match dynamics.steady {
            Some(_) => json!(AUTO),
            None => json!(dynamics.settle_s),
        },
        "start": match dynamics.start {
            Start::Prepared => "prepared",
            Start::Centred => "centred",
        },
        "start_tension": match dynamics.centred.tension {
            StartTension::Static => "static",
            StartTension::Cold => "cold",
        },
        "start_ramp_s": dynamics.centred.ramp_s,
        "friction_law": match dynamics.friction_law {
            FrictionLaw::Vector => "vector",
            FrictionLaw::Independent => "independent",
        },
        "stribeck_speed_m_per_s": dynamics.stribeck_speed_m_per_s,
        "damping": {
            "mass_per_s": dynamics.damping.mass_per_s,
            "stiffness_s": dynamics.damping.stiffness_s,
        },
        "sample_interval_s": dynamics.sample_interval_s,
        "checkpoint_interval_s": table.and_then(|table| table.checkpoint_interval.get()),
        "seed": dynamics.seed,
        "precision": match dynamics.precision {
            Precision::Double => "double",
            Precision::Single => "single",
        },
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
