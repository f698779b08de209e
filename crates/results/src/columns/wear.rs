//! Columns of `wear.parquet`.

use crate::ColumnSpec;

/// Columns of `wear.parquet`: the work of friction on the hole over the window, one row per 5 m of hole, from
/// the surface down, for each operation that was solved by dynamics.
pub const WEAR: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number("md_m", "m", "Measured depth of the middle of the stretch"),
    ColumnSpec::number(
        "wear_work_J_per_m",
        "J/m",
        "Work of friction over the window per metre of hole: force times sliding distance",
    ),
    ColumnSpec::number(
        "wear_power_W_per_m",
        "W/m",
        "Its mean rate; times 3600, the work in an hour of the same",
    ),
];
