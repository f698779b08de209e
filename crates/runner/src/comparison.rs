//! Results of a run next to each other: models and operations, in the user's units.

use wholestring::{
    operation::OperationKind,
    outcome::{ModelKind, scalars_by_row},
};
use wholestring_results::{Statistic, Status, Summary};
use wholestring_units::UnitSet;

use crate::checks::quantities::{shown, symbol};

/// The scalars of every operation and model.
#[derive(Debug)]
pub struct Comparison {
    /// Scalars that are compared.
    pub rows: Vec<ComparedRow>,
    /// Results, in the order of the summary.
    pub columns: Vec<ComparedColumn>,
}

/// A scalar.
#[derive(Debug)]
pub struct ComparedRow {
    /// Label of the scalar.
    pub label: &'static str,
    /// Symbol of its unit.
    pub symbol: &'static str,
    /// Decimals that show five digits of the largest value, at most three. Rows of one kind have
    /// the same decimals, so that they can be added up.
    pub decimals: usize,
}

/// Results of one operation and model.
#[derive(Debug)]
pub struct ComparedColumn {
    /// The operation.
    pub operation: OperationKind,
    /// The model of these results.
    pub model: ModelKind,
    /// Whether it was computed to its end.
    pub is_complete: bool,
    /// Value of each row, if there is one.
    pub values: Vec<Option<f64>>,
    /// Deviations about the mean, if the value varies with time.
    pub deviations: Option<Vec<Option<Deviation>>>,
}

/// Deviation of a value about its mean in time.
#[derive(Debug, Clone, Copy)]
pub struct Deviation {
    /// Standard deviation.
    pub std: f64,
    /// Direction in which the mean drifts, if it does.
    pub drift: Drift,
}

/// Direction of the drift of a mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drift {
    /// No drift.
    None,
    /// The mean increases.
    Upwards,
    /// The mean decreases.
    Downwards,
}

impl From<&Statistic> for Drift {
    fn from(statistic: &Statistic) -> Self {
        match (statistic.drifts, statistic.drift < 0.0) {
            (false, _) => Self::None,
            (true, false) => Self::Upwards,
            (true, true) => Self::Downwards,
        }
    }
}

impl Comparison {
    /// Compares the results of a run.
    pub fn of(summary: &Summary, units: UnitSet) -> Self {
        let scalars = scalars_by_row();
        let columns = summary.operations.iter().map(|solved| ComparedColumn {
            operation: solved.operation,
            model: solved.model,
            is_complete: solved.status == Status::Complete,
            values: scalars
                .iter()
                .map(|scalar| {
                    Some(shown(scalar.quantity.kind, (scalar.of)(&solved.scalars)?, units))
                })
                .collect(),
            deviations: solved.statistics.as_ref().map(|statistics| {
                let deviations = scalars.iter().map(|scalar| {
                    let statistic = statistics.get(scalar.quantity.name)?;
                    let std = shown(scalar.quantity.kind, statistic.std, units);
                    Some(Deviation { std, drift: statistic.into() })
                });
                deviations.collect()
            }),
        });
        let columns: Vec<ComparedColumn> = columns.collect();
        let rows =
            scalars.iter().map(|scalar| {
                let alike = (0..scalars.len())
                    .filter(|row| scalars[*row].quantity.kind == scalar.quantity.kind);
                ComparedRow {
                    label: scalar.label,
                    symbol: symbol(scalar.quantity.kind, units),
                    decimals: decimals(alike.flat_map(|row| {
                        columns.iter().filter_map(move |column| column.values[row])
                    })),
                }
            });
        Self { rows: rows.collect(), columns }
    }
}

fn decimals(values: impl Iterator<Item = f64>) -> usize {
    let largest = values.filter(|value| value.is_finite()).fold(0.0, |a: f64, b| a.max(b.abs()));
    if largest == 0.0 {
        return 1;
    }
    (4.0 - libm::log10(largest).floor()).clamp(0.0, 3.0) as usize
}
