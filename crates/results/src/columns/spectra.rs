//! Columns of `spectra.parquet`.

use wholestring::outcome::QuantityKind;

use crate::ColumnSpec;

/// Columns of `spectra.parquet`: power spectral densities over the window, a row per frequency.
pub const SPECTRA: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::text(
        "signal",
        "Column of `time.parquet` or, of a node, of `frames.parquet` without its unit: \
         `surface_torque`, ...",
    ),
    ColumnSpec::number(
        "md_m",
        QuantityKind::Depth,
        "Measured depth of the node; `null` for a scalar",
    )
    .null_where("it is a scalar's"),
    ColumnSpec::text("unit", "Unit of the signal"),
    ColumnSpec::number("frequency_Hz", QuantityKind::Frequency, "Frequency"),
    ColumnSpec::number(
        "density",
        QuantityKind::Ratio,
        "One-sided power spectral density, square of the signal's unit per Hz",
    ),
];
