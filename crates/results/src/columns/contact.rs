//! Columns of `contact.parquet`.

use crate::ColumnSpec;

/// Columns of `contact.parquet`: contact over depth and time, coarse, for each operation that was solved by
/// dynamics.
pub const CONTACT: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number(
        "time_s",
        "s",
        "Simulated time at the end of the average, settling included",
    ),
    ColumnSpec::number(
        "md_m",
        "m",
        "Measured depth of the middle of the stretch of string",
    ),
    ColumnSpec::number(
        "side_force_N_per_m",
        "N/m",
        "Mean side force per length since the time before; positive where the string lies on the high side",
    ),
    ColumnSpec::number(
        "contact_force_N_per_m",
        "N/m",
        "Mean magnitude of the contact force per length since the time before",
    ),
];
