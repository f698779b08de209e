//! Points of a plan: an operation at one depth with one friction.

use serde::{Deserialize, Serialize};
use wholestring::{
    operation::OperationKind,
    outcome::{ModelKind, Scalars},
    well::FrictionLevel,
};
use wholestring_judge::Check;

use crate::{
    Row, Table,
    columns::{FRICTION, MODEL, OPERATION},
    row::rows,
};

rows! {
    /// One operation at one depth with one friction.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanPoint {
        model: ModelKind => Words as MODEL, "The model";
        friction: FrictionLevel => Words as FRICTION, "Level of friction";
        operation: OperationKind => Words as OPERATION, "The operation";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        scalars: Option<Scalars>, "Torque and drag; none where there is no answer", columns {
            hook_load_N => Force,
                "Tension at the top of the string; block and top drive excluded; this and the \
                 other numbers are `null` where there is no answer",
                null_where "there is no answer";
            hook_load_with_block_N = |scalars| Some(scalars.hook_load_N + block_weight_N?) => Force,
                "The same with the block, the load of the hoist; `null` where the block's weight \
                 is not given or there is no answer",
                null_where "the block's weight is not given or there is no answer";
            surface_torque_N_m => Torque, "Torque at the top of the string, or `null`",
                null_where "there is no answer";
            weight_on_bit_N => Force, "Weight on bit, or `null`", null_where "there is no answer";
            bit_torque_N_m => Torque, "Bit torque, or `null`", null_where "there is no answer";
            friction_torque_N_m => Torque,
                "Part of the surface torque from wall contact alone, or `null`",
                null_where "there is no answer";
            axial_friction_N => Force,
                "Axial friction of the wall; positive adds to hook load; or `null`",
                null_where "there is no answer";
            side_force_total_N => Force,
                "Integral of the magnitude of the side force, or `null`",
                null_where "there is no answer";
            stretch_m => Length, "Elongation against the unloaded string, or `null`",
                null_where "there is no answer";
            twist_rad => Angle, "Turn of the top against the bit, or `null`",
                null_where "there is no answer";
            neutral_point_m => Depth,
                "Measured depth of the shallowest zero of effective tension; `null` where there is \
                 none",
                null_where "there is none";
        };
        buckling: Option<String> => Words,
            "Most severe buckling along the string: `none`, `sinusoidal` or `helical`; empty \
             without an answer",
            null_where "there is no answer";
        worst: Option<Check>,
            "The most severe check that needs attention; for a point without an answer the verdict \
             on it",
            columns {
                worst_check = |check| check.kind => Words,
                    "The most severe check, as for a run; for a point without an answer the \
                     verdict on it; empty where all limits are met",
                    null_where "all limits are met";
                worst_severity = |check| check.severity => Words,
                    "Its severity: `note`, `warning` or `error`, or empty",
                    null_where "all limits are met";
                worst_md_m = |check| check.md_m => Depth,
                    "Measured depth of its upper end; `null` where it has no place",
                    null_where "it has no place";
            };
        message: Option<String> => Words, "Reason why there is no answer; else empty",
            null_where "there is an answer";
    }

    /// Columns of `plan_broomstick.parquet`: a row for each depth of the bit, down the hole, of
    /// each model, operation and friction.
    pub const PLAN_BROOMSTICK with block_weight_N: Option<f64>;
}

/// A row for each point, of a rig with a block of this weight, N.
pub fn plan_broomstick_table(points: &[PlanPoint], block_weight_N: Option<f64>) -> Table {
    Row::table(points.iter().map(|point| (point, block_weight_N)))
}
