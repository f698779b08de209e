//! What hook load and torque may come to at the surface.

use serde::{Deserialize, Serialize};

use crate::{PLAN_SURFACE_LIMITS, Table};

/// A limit that hook load or surface torque is held against.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanSurfaceLimit {
    /// What it is of: `hoist`, `tension`, `top_drive`, `top_drive_peak`, `make_up` or `torsion`.
    pub kind: String,
    /// The topmost component; none of the rig.
    pub component: Option<String>,
    /// Whether it is of torque, N·m, and not of hook load, N.
    pub is_torque: bool,
    /// What is borne; of the hoist with the block.
    pub capacity: f64,
    /// The least factor that is to be kept.
    pub required: f64,
    /// What hook load without the block, or torque, may come to with that factor.
    pub allowed: f64,
}

/// A row for each limit at the surface and at the deepest bit, m: it is the same at all depths.
pub(super) fn table(limits: &[PlanSurfaceLimit], deepest_m: f64) -> Table {
    let mut table = Table::with_columns(PLAN_SURFACE_LIMITS);
    for of in limits {
        let (values, none) = ([of.capacity, of.allowed], [f64::NAN; 2]);
        let (weights, torques) = if of.is_torque { (none, values) } else { (values, none) };
        for bit_depth_m in [0.0, deepest_m] {
            table.append(
                &[
                    ("kind", &[&of.kind]),
                    ("component", &[of.component.as_deref().unwrap_or_default()]),
                ],
                &[
                    ("bit_depth_m", &[bit_depth_m]),
                    ("required", &[of.required]),
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
