//! The table of the limits of a reach.

use crate::{REACH_LIMITS, ReachSummary, Table};

/// `reach_limits.parquet`: a row for each limit.
pub fn reach_limits_table(summary: &ReachSummary) -> Table {
    let mut table = Table::with_columns(REACH_LIMITS);
    let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
    let flag = |value: bool| [f64::from(u8::from(value))];
    for answer in &summary.frictions {
        for limit in &answer.limits {
            table.append(
                &[("operation", &[limit.operation.name()]), ("limit", &[&limit.limit])],
                &[
                    ("friction", &number(answer.friction)),
                    ("stops", &flag(limit.stops)),
                    ("depth_m", &number(limit.depth_m)),
                    ("already", &flag(limit.already)),
                    ("margin_at_from", &number(limit.margin_at_from)),
                    ("margin_at_to", &number(limit.margin_at_to)),
                    ("md_m", &number(limit.at_md_m)),
                ],
            );
        }
    }
    table
}
