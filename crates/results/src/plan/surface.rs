//! Allowable hook load and torque at the surface.

use serde::{Deserialize, Serialize};

use crate::{Row, Table, row::rows};

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
