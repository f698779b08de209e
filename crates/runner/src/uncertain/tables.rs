//! Tables of uncertain inputs and their effects.

use wholestring_results::{
    ResultsError, ResultsFolder, Table, UNCERTAIN_SAMPLES, UncertainSummary, UncertainTables,
};

use super::{Sampled, Sampler};

/// Writes the tables, also as CSV; without samples, removes earlier ones.
pub(crate) fn write(
    folder: &ResultsFolder,
    names: &UncertainTables,
    results: Option<(&UncertainSummary, &Table)>,
) -> Result<(), ResultsError> {
    let Some((summary, samples)) = results else {
        for name in [names.bands, names.indices, names.samples].into_iter().chain(names.stops) {
            for ending in ["parquet", "csv"] {
                folder.remove(&format!("{name}.{ending}"))?;
            }
        }
        return Ok(());
    };
    folder.write_table(names.bands, &summary.table(), true)?;
    folder.write_table(names.indices, &summary.indices_table(), true)?;
    folder.write_table(names.samples, samples, true)?;
    match names.stops {
        Some(name) => folder.write_table(name, &summary.stops_table(), true),
        None => Ok(()),
    }
}

/// Sampled inputs, a row for each sample and input.
pub(crate) fn samples_table(sampler: &Sampler<'_>, sampled: &[Option<Sampled>]) -> Table {
    let mut table = Table::with_columns(UNCERTAIN_SAMPLES);
    for (place, (point, sampled)) in sampler.points.iter().zip(sampled).enumerate() {
        let lacking = sampled.as_ref().map_or(f64::NAN, |sampled| sampled.lacking as f64);
        let message =
            sampled.as_ref().and_then(|sampled| sampled.message.as_deref()).unwrap_or_default();
        for (input, value) in sampler.uncertain.inputs.iter().zip(point) {
            table.append(
                &[
                    ("input", &[&input.key]),
                    ("unit", &[&input.unit]),
                    ("written", &[&input.written(*value)]),
                    ("message", &[message]),
                ],
                &[
                    ("sample", &[place as f64 + 1.0]),
                    ("value", &[input.number(*value)]),
                    ("without_answer", &[lacking]),
                ],
            );
        }
    }
    table
}

/// Writes the numbers of the picture of the indices; without indices, removes an earlier one.
pub(crate) fn write_picture_numbers(
    folder: &ResultsFolder,
    summary: Option<&UncertainSummary>,
) -> Result<(), ResultsError> {
    match summary.filter(|summary| summary.inputs.len() > 1) {
        Some(summary) => summary.indices_table().write_csv(&folder.path().join("uncertain.csv")),
        None => folder.remove("uncertain.csv"),
    }
}
