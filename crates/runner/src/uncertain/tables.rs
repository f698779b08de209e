//! Tables of uncertain inputs and their effects.

use wholestring_results::{
    ResultsError, ResultsFolder, Row as _, Table, UncertainSample, UncertainSummary,
    UncertainTables,
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
    let samples = sampler.points.iter().zip(sampled).enumerate();
    let rows = samples.flat_map(|(place, (point, sampled))| {
        let values = sampler.uncertain.inputs.iter().zip(point);
        values.map(move |(input, value)| UncertainSample {
            sample: place + 1,
            input: input.key.clone(),
            value: input.number(*value),
            unit: input.unit.clone(),
            written: input.written(*value),
            without_answer: sampled.as_ref().map(|sampled| sampled.lacking),
            message: sampled.as_ref().and_then(|sampled| sampled.message.clone()),
        })
    });
    UncertainSample::table(rows)
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
