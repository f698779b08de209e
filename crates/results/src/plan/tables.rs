//! The tables of a plan: the contents of its summary, row by row.

use super::{PlanCheck, PlanFriction, PlanPoint, PlanSummary};
use crate::{PLAN_BROOMSTICK, PLAN_BUCKLING, PLAN_LIMITS, Row, Table};

/// A row for each limit with a load and a capacity.
pub fn plan_limits_table(checks: &[PlanCheck]) -> Table {
    let mut table = Table::with_columns(PLAN_LIMITS);
    for row in checks {
        let check = &row.check;
        let (Some(load), Some(capacity)) = (check.value, check.limit) else { continue };
        let (Some(factor), Some(required)) = (check.factor, check.required) else { continue };
        table.append(
            &[
                ("model", &[row.model.name()]),
                ("friction", &[row.friction.name()]),
                ("operation", &[row.operation.name()]),
                ("kind", &[check.kind.name()]),
                ("component", &[check.component.as_deref().unwrap_or_default()]),
                ("unit", &[&check.unit]),
                ("verdict", &[check.verdict.words()]),
                ("severity", &[check.severity.name()]),
            ],
            &[
                ("bit_depth_m", &[row.bit_depth_m]),
                ("md_m", &[check.md_m.unwrap_or(f64::NAN)]),
                ("load", &[load]),
                ("capacity", &[capacity]),
                ("factor", &[factor]),
                ("required", &[required]),
            ],
        );
    }
    table
}

/// A row for each point, of a rig with a block of this weight, N.
pub fn plan_broomstick_table(points: &[PlanPoint], block_weight_N: Option<f64>) -> Table {
    let mut table = Table::with_columns(PLAN_BROOMSTICK);
    for point in points {
        let worst = point.worst.as_ref();
        let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
        let scalars = point.scalars.as_ref();
        let with_block_N = scalars.and_then(|scalar| Some(scalar.hook_load_N + block_weight_N?));
        table.append(
            &[
                ("model", &[point.model.name()]),
                ("friction", &[point.friction.name()]),
                ("operation", &[point.operation.name()]),
                ("buckling", &[point.buckling.as_deref().unwrap_or_default()]),
                ("worst_check", &[worst.map_or("", |check| check.kind.name())]),
                ("worst_severity", &[worst.map_or("", |check| check.severity.name())]),
                ("message", &[point.message.as_deref().unwrap_or_default()]),
            ],
            &[
                ("bit_depth_m", &[point.bit_depth_m]),
                ("hook_load_N", &number(scalars.map(|scalar| scalar.hook_load_N))),
                ("hook_load_with_block_N", &number(with_block_N)),
                ("surface_torque_N_m", &number(scalars.map(|scalar| scalar.surface_torque_N_m))),
                ("weight_on_bit_N", &number(scalars.map(|scalar| scalar.weight_on_bit_N))),
                ("bit_torque_N_m", &number(scalars.map(|scalar| scalar.bit_torque_N_m))),
                ("friction_torque_N_m", &number(scalars.map(|scalar| scalar.friction_torque_N_m))),
                ("axial_friction_N", &number(scalars.map(|scalar| scalar.axial_friction_N))),
                ("side_force_total_N", &number(scalars.map(|scalar| scalar.side_force_total_N))),
                ("stretch_m", &number(scalars.map(|scalar| scalar.stretch_m))),
                ("twist_rad", &number(scalars.map(|scalar| scalar.twist_rad))),
                ("neutral_point_m", &number(scalars.and_then(|scalar| scalar.neutral_point_m))),
                ("worst_md_m", &number(worst.and_then(|worst| worst.md_m))),
            ],
        );
    }
    table
}

impl PlanSummary {
    /// A row for each point.
    pub fn broomstick_table(&self) -> Table {
        plan_broomstick_table(&self.points, self.settings["rig"]["block_weight_N"].as_f64())
    }

    /// A row for each weight to buckle.
    pub fn buckling_table(&self) -> Table {
        let mut table = Table::with_columns(PLAN_BUCKLING);
        for point in &self.buckling {
            let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
            table.append(
                &[
                    ("model", &[point.model.name()]),
                    ("friction", &[point.friction.name()]),
                    ("operation", &[point.operation.name()]),
                    ("message", &[point.message.as_deref().unwrap_or_default()]),
                ],
                &[
                    ("bit_depth_m", &[point.bit_depth_m]),
                    ("sinusoidal_weight_N", &number(point.sinusoidal_weight_N)),
                    ("helical_weight_N", &number(point.helical_weight_N)),
                ],
            );
        }
        table
    }

    /// A row for each hole section at each level of friction.
    pub fn friction_table(&self) -> Table {
        PlanFriction::table(&self.frictions)
    }
}
