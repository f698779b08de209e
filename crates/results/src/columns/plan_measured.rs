//! Columns of what was measured, beside a plan.

use super::specs;
use crate::ColumnSpec;

/// Columns of `plan_measured.parquet`: a row for each weight and torque that was read, of each model.
/// Predicted is with the friction that is expected, of the string that was in the hole.
pub const PLAN_MEASURED: &[ColumnSpec] = specs! {
    "model": Words, "Model that predicts: `soft` or `stiff`";
    "operation": Words, "`trip_out`, `drill`, ...";
    "place": Words, "Where the reading stands in its file";
    "reading": Words, "`pick_up`, `slack_off`, `rotating`, `torque` or `torque_on_bottom`";
    "held_out": Ratio, "1 where the file holds it out of a calibration, 0 otherwise";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "measured_N": Force, "Weight as it was read, block included; `null` of torques",
        null_where "it is a torque";
    "hook_load_N": Force,
        "The same without the block: what stands beside `plan_broomstick`; `null` of torques",
        null_where "it is a torque";
    "low_friction_N": Force, "The same predicted with low friction; `null` of torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "predicted_N": Force, "With the friction that is expected; `null` of torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "high_friction_N": Force, "With high friction; `null` of torques and without an answer", null_where "it is a torque, or there is no answer";
    "residual_N": Force, "Measured less predicted; `null` of torques and without an answer", null_where "it is a torque, or there is no answer";
    "measured_N_m": Torque, "Torque as it was read; `null` of weights", null_where "it is a weight";
    "low_friction_N_m": Torque, "The same predicted with low friction; `null` of weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "predicted_N_m": Torque, "With the friction that is expected; `null` of weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "high_friction_N_m": Torque, "With high friction; `null` of weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "residual_N_m": Torque, "Measured less predicted; `null` of weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "between": Words,
        "Whether it lies between low and high friction: `yes` or `no`; empty where friction does not move it \
         or there is no answer",
        null_where "friction does not move it, or there is no answer";
    "message": Words, "Why there is no answer; else empty", null_where "there is an answer";
};
