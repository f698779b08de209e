//! Columns of `wear.parquet`.

use super::DYNAMIC;
use crate::ColumnSpec;

/// Columns of `wear.parquet`: the work of friction on the hole, one row per 5 m of hole, from the surface down, for each
/// model and operation.
pub const WEAR: &[ColumnSpec] = &[
    ColumnSpec::text("model", "`soft` or `dynamic`"),
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number("md_m", "m", "Measured depth of the middle of the stretch"),
    ColumnSpec::number(
        "wear_work_J_per_m",
        "J/m",
        "Work of friction over the window per metre of hole: force times sliding distance",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "wear_power_W_per_m",
        "W/m",
        "Its mean rate, of a soft string the rate: force times sliding speed; times 3600, the work in an hour of the same",
    ),
];
