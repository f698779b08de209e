//! Columns of the tables of a plan.

use super::{FRICTION, MODEL, OPERATION};
use crate::ColumnSpec;

/// Adds the columns that identify the rows: model, operation and friction.
macro_rules! plan_specs {
    ($($name:literal: $kind:ident, $meaning:literal $(, null_where $none:literal)?;)+) => {
        &[
            MODEL,
            FRICTION,
            OPERATION,
            $($crate::columns::specs!(@one $name, $kind, $meaning)$(.null_where($none))?),+
        ]
    };
}

/// Columns of `plan_broomstick.parquet`: a row for each depth of the bit, down the hole, of each
/// model, operation and friction.
pub const PLAN_BROOMSTICK: &[ColumnSpec] = plan_specs! {
    "bit_depth_m": Depth, "Measured depth of the bit";
    "hook_load_N": Force,
        "Tension at the top of the string; block and top drive excluded; this and the other \
         numbers are `null` where there is no answer",
        null_where "there is no answer";
    "hook_load_with_block_N": Force,
        "The same with the block, the load of the hoist; `null` where the block's weight is not \
         given or there is no answer",
        null_where "the block's weight is not given or there is no answer";
    "surface_torque_N_m": Torque, "Torque at the top of the string, or `null`",
        null_where "there is no answer";
    "weight_on_bit_N": Force, "Weight on bit, or `null`", null_where "there is no answer";
    "bit_torque_N_m": Torque, "Bit torque, or `null`", null_where "there is no answer";
    "friction_torque_N_m": Torque,
        "Part of the surface torque from wall contact alone, or `null`",
        null_where "there is no answer";
    "axial_friction_N": Force, "Axial friction of the wall; positive adds to hook load; or `null`",
        null_where "there is no answer";
    "side_force_total_N": Force, "Integral of the magnitude of the side force, or `null`",
        null_where "there is no answer";
    "stretch_m": Length, "Elongation against the unloaded string, or `null`",
        null_where "there is no answer";
    "twist_rad": Angle, "Turn of the top against the bit, or `null`",
        null_where "there is no answer";
    "neutral_point_m": Depth,
        "Measured depth of the shallowest zero of effective tension; `null` where there is none",
        null_where "there is none";
    "buckling": Words,
        "Most severe buckling along the string: `none`, `sinusoidal` or `helical`; empty without \
         an answer",
        null_where "there is no answer";
    "worst_check": Words,
        "The most severe check, as for a run; for a point without an answer the verdict on it; \
         empty where all limits are met",
        null_where "all limits are met";
    "worst_severity": Words, "Its severity: `note`, `warning` or `error`, or empty",
        null_where "all limits are met";
    "worst_md_m": Depth, "Measured depth of its upper end; `null` where it has no place",
        null_where "it has no place";
    "message": Words, "Reason why there is no answer; else empty", null_where "there is an answer";
};

/// Columns of `plan_buckling.parquet`: the weight on bit under which the string begins to buckle, a
/// row for each depth of the bit, of each operation that drills and each friction.
pub const PLAN_BUCKLING: &[ColumnSpec] = plan_specs! {
    "bit_depth_m": Depth, "Measured depth of the bit";
    "sinusoidal_weight_N": Force,
        "Least weight on bit at which part of the string buckles to a sinusoid, 0 where it does \
         without any; `null` where no weight does or there is no answer",
        null_where "no weight does, or there is no answer";
    "helical_weight_N": Force, "The same for a helix, or `null`",
        null_where "no weight does, or there is no answer";
    "message": Words, "Reason why there is no answer; else empty", null_where "there is an answer";
};

/// Columns of `plan_limits.parquet`: a load against its capacity, for each depth of the bit, model,
/// operation, friction, kind of limit and component at the place with the least reserve.
pub const PLAN_LIMITS: &[ColumnSpec] = plan_specs! {
    "bit_depth_m": Depth, "Measured depth of the bit";
    "kind": Words, "`tension`, `torsion`, `von_mises`, `hoist`, ...";
    "component": Words, "The component; empty for the rig", null_where "it is of the rig";
    "md_m": Depth, "Measured depth of the place, or `null` for the rig",
        null_where "it is of the rig";
    "load": Ratio, "The load, in `unit`";
    "capacity": Ratio, "The capacity, in `unit`";
    "unit": Words, "`N`, `N·m` or `Pa`";
    "factor": Ratio, "Capacity over load";
    "required": Ratio, "The required factor";
    "verdict": Words,
        "`OK`, `marginal` (met by less than a tenth), `below required factor` or `exceeded` (the \
         load is larger than the capacity)";
    "severity": Words, "`ok`, `note`, `warning` or `error`";
};
