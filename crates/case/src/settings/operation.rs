//! `operation` in the record of a run.

use serde_json::Value as Json;
use wholestring::{
    dynamics::{HoistSetPoint, Schedule, ScheduleStep},
    operation::Operation,
};

use super::fields::Fields;

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
