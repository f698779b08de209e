//! Columns of `spectra.parquet`.

use crate::ColumnSpec;

/// Columns of `spectra.parquet`: power spectral densities of scalars over the window, a row per frequency.
pub const SPECTRA: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::text(
        "signal",
        "Column of `time.parquet` without its unit: `surface_torque`, ...",
    ),
    ColumnSpec::text("unit", "Unit of the signal"),
    ColumnSpec::number("frequency_Hz", "Hz", "Frequency"),
    ColumnSpec::number(
        "density",
        "",
        "One-sided power spectral density, square of the signal's unit per Hz",
    ),
];
