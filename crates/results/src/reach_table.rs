//! The table of the limits of a reach.

use crate::{REACH_LIMITS, ReachSummary, Table};

/// `reach_limits.parquet`: a row for each limit.
pub fn reach_limits_table(summary: &ReachSummary) -> Table {
    let mut table = Table::with_columns(REACH_LIMITS);
    let number = |of: Option<f64>| [of.unwrap_or(f64::NAN)];
    let flag = |of: bool| [f64::from(u8::from(of))];
    for answer in &summary.frictions {
        for of in &answer.limits {
            table.append(
                &[("operation", &[&of.operation]), ("limit", &[&of.limit])],
                &[
                    ("friction", &number(answer.friction)),
                    ("stops", &flag(of.stops)),
                    ("depth_m", &number(of.depth_m)),
                    ("already", &flag(of.already)),
                    ("margin_at_from", &number(of.margin_at_from)),
                    ("margin_at_to", &number(of.margin_at_to)),
                    ("md_m", &number(of.at_md_m)),
                ],
            );
        }
    }
    table
}
