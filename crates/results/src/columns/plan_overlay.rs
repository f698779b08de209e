//! Columns of another program's curves, to compare with a plan.

use super::specs;
use crate::ColumnSpec;

/// Columns of `plan_overlay.parquet`: a row for each weight and torque of another program, for each
/// model of the plan. Our values use the expected friction and are interpolated linearly between
/// the depths of the plan.
pub const PLAN_OVERLAY: &[ColumnSpec] = specs! {
    "model": Words, "Model of the plan: `soft` or `stiff`";
    "operation": Words, "`trip_out`, `trip_in`, `rotate_off_bottom` or `drill`";
    "place": Words, "Place of their value in its file";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "theirs_N": Force, "Their hook load, as in the file; `null` for torques",
        null_where "it is a torque";
    "ours_N": Force, "Ours, block excluded; `null` for torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "difference_N": Force, "Ours less theirs; `null` for torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "theirs_N_m": Torque, "Their torque; `null` for weights", null_where "it is a weight";
    "ours_N_m": Torque, "Our torque; `null` for weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "difference_N_m": Torque, "Ours less theirs; `null` for weights and without an answer",
        null_where "it is a weight, or there is no answer";
};
