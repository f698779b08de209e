//! Columns of measured readings, to compare with a plan.

use super::specs;
use crate::ColumnSpec;

/// Columns of `plan_measured.parquet`: a row for each measured weight and torque, for each model.
/// Predictions use the expected friction and the string that was in the hole.
pub const PLAN_MEASURED: &[ColumnSpec] = specs! {
    "model": Words, "Model that predicts: `soft` or `stiff`";
    "operation": Words, "`trip_out`, `drill`, ...";
    "place": Words, "Place of the reading in its file";
    "reading": Words, "`pick_up`, `slack_off`, `rotating`, `torque` or `torque_on_bottom`";
    "held_out": Ratio, "1 where the file holds it out of a calibration, 0 otherwise";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "measured_N": Force, "Measured weight, block included; `null` for torques",
        null_where "it is a torque";
    "hook_load_N": Force,
        "The same without the block, comparable with `plan_broomstick`; `null` for torques",
        null_where "it is a torque";
    "low_friction_N": Force,
        "The same predicted with low friction; `null` for torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "predicted_N": Force, "With the expected friction; `null` for torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "high_friction_N": Force, "With high friction; `null` for torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "residual_N": Force, "Measured less predicted; `null` for torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "measured_N_m": Torque, "Measured torque; `null` for weights", null_where "it is a weight";
    "low_friction_N_m": Torque,
        "The same predicted with low friction; `null` for weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "predicted_N_m": Torque, "With the expected friction; `null` for weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "high_friction_N_m": Torque, "With high friction; `null` for weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "residual_N_m": Torque, "Measured less predicted; `null` for weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "between": Words,
        "Whether it is between the values of low and high friction: `yes` or `no`; empty where \
         friction does not change it or there is no answer",
        null_where "friction does not change it, or there is no answer";
    "message": Words, "Reason why there is no answer; else empty", null_where "there is an answer";
};
