//! Power spectral densities of a run.

use std::path::Path;

use wholestring::operation::OperationKind;
use wholestring_report::{Packed, Spectrum, SpectrumPicture, spectrum_dimension};
use wholestring_results::{ResultsError, Table};

use super::rows::rows;
use crate::column::{numbers, words};

/// The power spectral densities in the table of a file.
///
/// # Errors
/// A row without a known operation.
pub(crate) fn spectra(table: &Table, path: &Path) -> Result<Vec<Spectrum>, ResultsError> {
    let row = |row: usize| Ok((row, table.operation(row, path)?));
    let rows: Vec<_> = (0..table.rows()).map(row).collect::<Result<_, ResultsError>>()?;
    Ok(in_rows(table, rows))
}

/// The power spectral densities in these rows, whose operations are known.
fn in_rows(table: &Table, rows: impl IntoIterator<Item = (usize, OperationKind)>) -> Vec<Spectrum> {
    let text = |name: &str, row: usize| words(table, name).get(row).cloned().unwrap_or_default();
    let number = |name: &str, row: usize| numbers(table, name).get(row).copied().flatten();
    let mut spectra: Vec<Spectrum> = Vec::new();
    for (row, operation) in rows {
        let signal = text("signal", row);
        let md_m = number("md_m", row);
        let same = |spectrum: &Spectrum| {
            spectrum.operation == operation && spectrum.signal == signal && spectrum.md_m == md_m
        };
        if !spectra.last().is_some_and(same) {
            spectra.push(Spectrum {
                operation,
                signal,
                md_m,
                unit: text("unit", row),
                frequency_Hz: Vec::new(),
                density: Vec::new(),
            });
        }
        if let Some(spectrum) = spectra.last_mut() {
            spectrum.frequency_Hz.push(number("frequency_Hz", row).unwrap_or(f64::NAN));
            spectrum.density.push(number("density", row).unwrap_or(f64::NAN));
        }
    }
    spectra
}

/// Spectra of an operation for the page.
pub(super) fn pictures(table: &Table, operation: OperationKind) -> Vec<SpectrumPicture> {
    let rows = rows(table, None, operation).into_iter().map(|row| (row, operation));
    in_rows(table, rows)
        .into_iter()
        .map(|mine| SpectrumPicture {
            dimension: spectrum_dimension(&mine.signal, mine.md_m.is_some())
                .unwrap_or_default()
                .into(),
            frequency_Hz: Packed::single(mine.frequency_Hz),
            density: Packed::single(mine.density),
            signal: mine.signal,
            md_m: mine.md_m,
        })
        .collect()
}
