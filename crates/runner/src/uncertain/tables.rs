//! The tables of what is not known exactly.

use wholestring_results::{
    ResultsError, ResultsFolder, Table, UNCERTAIN_SAMPLES, UncertainSummary,
};

use super::{Sampled, Sampler};

/// Names of the tables of a plan or a reach, without their endings.
pub(crate) struct Names {
    /// How the samples scatter.
    pub(crate) bands: &'static str,
    /// Which inputs that is owed to.
    pub(crate) indices: &'static str,
    /// What was drawn.
    pub(crate) samples: &'static str,
    /// What stops the well first, and how often; a plan has no stops.
    pub(crate) stops: Option<&'static str>,
}

impl Names {
    /// Of a plan.
    pub(crate) const PLAN: Self = Self {
        bands: "plan_uncertain",
        indices: "plan_uncertain_indices",
        samples: "plan_uncertain_samples",
        stops: None,
    };
    /// Of a reach.
    pub(crate) const REACH: Self = Self {
        bands: "reach_uncertain",
        indices: "reach_uncertain_indices",
        samples: "reach_uncertain_samples",
        stops: Some("reach_uncertain_stops"),
    };
}

/// Writes the tables, as CSV too; those of earlier samples go where there are none.
pub(crate) fn write(
    folder: &ResultsFolder,
    names: &Names,
    of: Option<(&UncertainSummary, &Table)>,
) -> Result<(), ResultsError> {
    let Some((summary, samples)) = of else {
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

/// What was drawn, a row for each sample and input.
pub(crate) fn samples_table(sampler: &Sampler<'_>, sampled: &[Option<Sampled>]) -> Table {
    let mut table = Table::with_columns(UNCERTAIN_SAMPLES);
    for (place, (point, sampled)) in sampler.points.iter().zip(sampled).enumerate() {
        let lacking = sampled.as_ref().map_or(f64::NAN, |of| of.lacking as f64);
        let message = sampled.as_ref().and_then(|of| of.message.as_deref()).unwrap_or_default();
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

/// Writes the numbers of the picture of the indices; those of an earlier one go where there is none.
pub(crate) fn write_picture_numbers(
    folder: &ResultsFolder,
    of: Option<&UncertainSummary>,
) -> Result<(), ResultsError> {
    match of.filter(|of| of.inputs.len() > 1) {
        Some(of) => of.indices_table().write_csv(&folder.path().join("uncertain.csv")),
        None => folder.remove("uncertain.csv"),
    }
}
