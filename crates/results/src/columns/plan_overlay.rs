//! Columns of another program's curves, beside a plan.

use super::specs;
use crate::ColumnSpec;

/// Columns of `plan_overlay.parquet`: a row for each weight and torque of another program, of each model of the plan.
/// Ours is with the friction that is expected, on a straight line between the depths of the plan.
pub const PLAN_OVERLAY: &[ColumnSpec] = specs! {
    "model": Words, "Model of the plan: `soft` or `stiff`";
    "operation": Words, "`trip_out`, `trip_in`, `rotate_off_bottom` or `drill`";
    "place": Words, "Where theirs stands in its file";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "theirs_N": Force, "Their hook load, as the file has it; `null` of torques", null_where "it is a torque";
    "ours_N": Force, "Ours, block excluded; `null` of torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "difference_N": Force, "Ours less theirs; `null` of torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "theirs_N_m": Torque, "Their torque; `null` of weights", null_where "it is a weight";
    "ours_N_m": Torque, "Our torque; `null` of weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "difference_N_m": Torque, "Ours less theirs; `null` of weights and without an answer",
        null_where "it is a weight, or there is no answer";
};
