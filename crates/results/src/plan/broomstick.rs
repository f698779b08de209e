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

// Weights on bit at which the string of a plan begins to buckle.

rows! {
    /// The weight on bit at which the string begins to buckle.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanBuckling {
        model: ModelKind => Words as MODEL, "The model: `soft`";
        friction: FrictionLevel => Words as FRICTION, "Level of friction";
        operation: OperationKind => Words as OPERATION, "The operation: `drill` or `slide`";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        sinusoidal_weight_N: Option<f64> => Force,
            "Least weight on bit at which part of the string buckles to a sinusoid, 0 where it \
             does without any; `null` where no weight does or there is no answer",
            null_where "no weight does, or there is no answer";
        helical_weight_N: Option<f64> => Force, "The same for a helix, or `null`",
            null_where "no weight does, or there is no answer";
        message: Option<String> => Words, "Reason why there is no answer; else empty",
            null_where "there is an answer";
    }

    /// Columns of `plan_buckling.parquet`: the weight on bit under which the string begins to
    /// buckle, a row for each depth of the bit, of each operation that drills and each friction.
    pub const PLAN_BUCKLING;
}

// Friction of the hole in a plan.

rows! {
    /// Friction of a hole section at a level.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanFriction {
        friction: FrictionLevel => Words as FRICTION, "Level of friction";
        kind: String => Words, "`casing` or `open`";
        from_md_m: f64 => Depth, "Measured depth of the section's upper end";
        to_md_m: f64 => Depth, "Measured depth of its lower end";
        along: f64 => Ratio, "Coefficient of axial friction";
        around: f64 => Ratio, "Coefficient of rotational friction";
    }

    /// Columns of `plan_friction.parquet`: a row for each hole section at each level of friction.
    pub const PLAN_FRICTION;
}

// Allowable hook load and torque at the surface.

rows! {
    /// A limit of hook load or surface torque.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanSurfaceLimit {
        kind: String => Words,
            "`hoist`, `tension`, `top_drive`, `top_drive_peak`, `make_up` or `torsion`";
        component: Option<String> => Words, "The topmost component; empty for the rig",
            null_where "it is of the rig";
        is_torque: bool, "Whether it limits torque, N·m, rather than hook load, N";
        capacity: f64, "The capacity; for the hoist with the block";
        bit_depth_m = |_| bit_depth_m => Depth, "Measured depth of the bit: zero, and the deepest";
        required: f64 => Ratio, "The required factor";
        allowed: f64, "Allowable hook load without the block, or torque, by that factor";
        is_torque = |limit| limit.is_torque, loads {
            capacity = |limit| limit.capacity,
                "The capacity, for the hoist with the block" | "The capacity";
            allowed = |limit| limit.allowed,
                "Allowable hook load without the block: capacity over factor, for the hoist less \
                 the block"
                | "Allowable torque: capacity over factor";
        };
    }

    /// Columns of `plan_surface_limits.parquet`: two rows for each limit, the ends of its line on
    /// the broomstick.
    pub const PLAN_SURFACE_LIMITS with bit_depth_m: f64;
}

/// A row for each limit at the surface and at the deepest bit, m: it is the same at all depths.
pub(super) fn table(limits: &[PlanSurfaceLimit], deepest_m: f64) -> Table {
    Row::table(limits.iter().flat_map(|limit| [(limit, 0.0), (limit, deepest_m)]))
}
