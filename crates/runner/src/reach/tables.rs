//! The table of the margins of a reach.

use wholestring_plan::reach::{Limit, Margin, OperationReach};
use wholestring_results::{REACH as COLUMNS, Table};

/// Names of the tables, without their endings.
pub(super) const REACH: &str = "reach";
pub(super) const LIMITS: &str = "reach_limits";

/// `reach.parquet`: a row for each margin at each depth. The answers of each friction stand one
/// after the other; none is the case's own.
pub(super) fn reach_table(answers: &[(Option<f64>, &[OperationReach])]) -> Table {
    let mut table = Table::with_columns(COLUMNS);
    for (friction, reaches) in answers {
        for reach in *reaches {
            for curve in &reach.curves {
                let margins = &curve.margins;
                let rows = margins.len();
                let each = |of: &dyn Fn(&Margin) -> f64| margins.iter().map(of).collect::<Vec<_>>();
                let of_unit = |unit: &str, of: fn(&Margin) -> f64| {
                    let is_such = curve.limit.unit() == unit;
                    each(&|margin| if is_such { of(margin) } else { f64::NAN })
                };
                let force = Limit::Hoist.unit();
                let torque = Limit::TopDrive.unit();
                table.append(
                    &[
                        ("operation", &vec![reach.kind.name(); rows]),
                        ("limit", &vec![curve.limit.name(); rows]),
                    ],
                    &[
                        ("friction", &vec![friction.unwrap_or(f64::NAN); rows]),
                        ("bit_depth_m", &reach.depth_m),
                        ("margin", &each(&|of| of.margin)),
                        ("force_N", &of_unit(force, |of| of.load)),
                        ("force_limit_N", &of_unit(force, |of| of.bound)),
                        ("torque_N_m", &of_unit(torque, |of| of.load)),
                        ("torque_limit_N_m", &of_unit(torque, |of| of.bound)),
                        ("md_m", &each(&|of| of.at_md_m.unwrap_or(f64::NAN))),
                    ],
                );
            }
        }
    }
    table
}
