//! Power spectral densities of a run.

use wholestring_report::{Packed, Spectrum, SpectrumPicture, spectrum_dimension};
use wholestring_results::Table;

use crate::column::{numbers, words};

/// The power spectral densities in a table.
pub(crate) fn spectra(table: &Table) -> Vec<Spectrum> {
    let text = |name: &str, row: usize| words(table, name).get(row).cloned().unwrap_or_default();
    let number = |name: &str, row: usize| numbers(table, name).get(row).copied().flatten();
    let mut spectra: Vec<Spectrum> = Vec::new();
    for row in 0..table.rows() {
        let (operation, signal) = (text("operation", row), text("signal", row));
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
pub(super) fn pictures(table: &Table, operation: &str) -> Vec<SpectrumPicture> {
    let mine = spectra(table).into_iter();
    mine.filter(|mine| mine.operation == operation)
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
