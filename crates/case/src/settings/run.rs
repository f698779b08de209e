//! `dynamics`, `records` and `operation` in the record of a run.

use serde_json::{Value as Json, json};
use wholestring::{
    dynamics::{
        ContactLaw, DynamicsSettings, ElementLength, HoistSetPoint, Regions, Schedule, ScheduleStep,
    },
    operation::Operation,
};

use super::fields::{Fields, word};
use crate::{dynamics::records::Records, values::auto::AUTO};

pub(super) fn run(dynamics: &DynamicsSettings, checkpoint_interval_s: Option<f64>) -> Fields {
    let fields = Fields::of(dynamics)
        // These have tables of their own.
        .without(["mesh", "hoist_control", "autodriller", "hoist_line"])
        .without(["lift_tolerance", "top_drive", "schedule", "bit", "probes"])
        .without(["steady"])
        .spread("centred", "start_")
        .spread_variant("contact_law", "contact_law")
        .words(["start", "start_tension", "friction_law", "precision"])
        .with("checkpoint_interval_s", checkpoint_interval_s);
    let fields = match dynamics.contact_law {
        ContactLaw::Hertz { .. } => {
            fields.renamed([("dissipation_s_per_m", "hertz_dissipation_s_per_m")])
        }
        ContactLaw::Linear { .. } => fields.renamed([
            ("stiffness_N_per_m", "contact_stiffness_N_per_m"),
            ("damping_ratio", "contact_damping_ratio"),
        ]),
    };
    match dynamics.steady {
        // A word where the run determines it: the numerics of each operation contain the value.
        Some(_) => fields.with("settle_s", AUTO),
        None => fields,
    }
}

/// `mesh` in the record of a run.
pub(super) fn mesh(dynamics: &DynamicsSettings) -> Fields {
    let fields = match dynamics.mesh.element_length {
        ElementLength::Uniform(length_m) => Fields::empty().with("element_length_m", length_m),
        ElementLength::Auto(accuracy) => {
            Fields::empty().with("element_length_m", AUTO).with("accuracy", word(&accuracy))
        }
    };
    let fields = match dynamics.mesh.refinement {
        1 => fields,
        refinement => fields.with("refinement", refinement),
    };
    match dynamics.mesh.regions {
        Regions::One => fields,
        Regions::Auto => fields.with("regions", word(&dynamics.mesh.regions)),
    }
}

pub(super) fn records(records: &Records) -> Fields {
    let channels = records.channels.iter().map(|channel| channel.name());
    let spectra = records.spectra.iter().map(|signal| signal.name());
    let probes = records.probes.iter();
    let probes = probes.map(|probe| json!({ "md_m": probe.md_m, "signal": probe.signal.name() }));
    Fields::of(records)
        .without(["probes"])
        .with("channels", channels.collect::<Vec<_>>())
        .with("spectra", spectra.collect::<Vec<_>>())
        .with("node_spectra", probes.collect::<Json>())
}

// `operation` in the record of a run.

/// The set points are those of the first; the others differ in their kind, and in the set points
/// that their kind excludes.
pub(super) fn operation(operations: &[Operation], plan: &Schedule) -> Fields {
    let kinds = operations.iter().map(|operation| operation.kind.name());
    let kinds: Vec<&str> = kinds.collect();
    let first = operations.first().map_or_else(Fields::empty, Fields::of);
    first
        // The bit's torque is in the bit's table; its motor's pressure follows from it.
        .without(["bit_torque_N_m", "motor_pressure_drop_Pa"])
        .renamed([("weight_on_bit_N", "wob_N"), ("rate_of_penetration_m_per_s", "rop_m_per_s")])
        .with("kind", kinds)
        .with("schedule", schedule(plan))
}

/// The lines of a schedule; set points that a line does not change are `null`.
fn schedule(schedule: &Schedule) -> Json {
    let steps = schedule.steps.iter();
    steps.map(|line| Json::from(step(line))).collect()
}

fn step(step: &ScheduleStep) -> Fields {
    let (velocity, weight) = match step.hoist {
        Some(HoistSetPoint::BlockVelocity(velocity)) => (Some(velocity), None),
        Some(HoistSetPoint::WeightOnBit(weight)) => (None, Some(weight)),
        None => (None, None),
    };
    Fields::of(step)
        .without(["hoist"])
        .with("block_velocity_m_per_s", velocity)
        .with("wob_N", weight)
}
