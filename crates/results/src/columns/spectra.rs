//! Columns of `spectra.parquet`.

use super::specs;
use crate::ColumnSpec;

/// Columns of `spectra.parquet`: power spectral densities over the window, a row per frequency.
pub const SPECTRA: &[ColumnSpec] = specs! {
    "operation": Words, "`trip_out`, `drill`, ...";
    "signal": Words,
        "Column of `time.parquet` or, of a node, of `frames.parquet` without its unit: \
         `surface_torque`, ...";
    "md_m": Depth, "Measured depth of the node; `null` for a scalar", null_where "it is a scalar's";
    "unit": Words, "Unit of the signal";
    "frequency_Hz": Frequency, "Frequency";
    "density": Ratio, "One-sided power spectral density, square of the signal's unit per Hz";
};
