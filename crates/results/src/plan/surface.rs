//! Allowable hook load and torque at the surface.

use serde::{Deserialize, Serialize};

use crate::{PLAN_SURFACE_LIMITS, Table};

/// A limit of hook load or surface torque.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanSurfaceLimit {
    /// Kind of the limit: `hoist`, `tension`, `top_drive`, `top_drive_peak`, `make_up` or
    /// `torsion`.
    pub kind: String,
    /// The topmost component; none for the rig.
    pub component: Option<String>,
    /// Whether it limits torque, N·m, rather than hook load, N.
    pub is_torque: bool,
    /// The capacity; for the hoist with the block.
    pub capacity: f64,
    /// The required factor.
    pub required: f64,
    /// Allowable hook load without the block, or torque, by that factor.
    pub allowed: f64,
}

/// A row for each limit at the surface and at the deepest bit, m: it is the same at all depths.
pub(super) fn table(limits: &[PlanSurfaceLimit], deepest_m: f64) -> Table {
    let mut table = Table::with_columns(PLAN_SURFACE_LIMITS);
    for limit in limits {
        let (values, none) = ([limit.capacity, limit.allowed], [f64::NAN; 2]);
        let (weights, torques) = if limit.is_torque { (none, values) } else { (values, none) };
        for bit_depth_m in [0.0, deepest_m] {
            table.append(
                &[
                    ("kind", &[&limit.kind]),
                    ("component", &[limit.component.as_deref().unwrap_or_default()]),
                ],
                &[
                    ("bit_depth_m", &[bit_depth_m]),
                    ("required", &[limit.required]),
                    ("capacity_N", &[weights[0]]),
                    ("allowed_N", &[weights[1]]),
                    ("capacity_N_m", &[torques[0]]),
                    ("allowed_N_m", &[torques[1]]),
                ],
            );
        }
    }
    table
}
