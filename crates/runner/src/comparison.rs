//! The answers of a run side by side: models and operations, in the user's units.

use wholestring::outcome::{ModelKind, scalars_by_row};
use wholestring_results::{Statistic, Status, Summary};
use wholestring_units::UnitSet;

use crate::checks::quantities::{shown, symbol};

/// The scalars of every operation and model.
#[derive(Debug)]
pub struct Comparison<'a> {
    /// What is compared.
    pub rows: Vec<ComparedRow>,
    /// The answers, in the order of the summary.
    pub columns: Vec<ComparedColumn<'a>>,
}

/// A scalar.
#[derive(Debug)]
pub struct ComparedRow {
    /// What people call it.
    pub label: &'static str,
    /// Symbol of its unit.
    pub symbol: &'static str,
    /// Decimals that show five digits of the largest value, three at most. Rows of one kind show
    /// the
    /// same decimals, so that they can be added up.
    pub decimals: usize,
}

/// One answer.
#[derive(Debug)]
pub struct ComparedColumn<'a> {
    /// The operation.
    pub operation: &'a str,
    /// The model that it is of.
    pub model: ModelKind,
    /// Whether it was computed to its end.
    pub is_complete: bool,
    /// A value for each row, where it has one.
    pub values: Vec<Option<f64>>,
    /// How far each varies about its mean, where it varies in time.
    pub deviations: Option<Vec<Option<Deviation>>>,
}

/// How far a mean is from standing still.
#[derive(Debug, Clone, Copy)]
pub struct Deviation {
    /// Standard deviation.
    pub std: f64,
    /// Where the mean goes to, if it does.
    pub drift: Drift,
}

/// Where a mean goes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drift {
    /// It stands still.
    None,
    /// It grows.
    Upwards,
    /// It falls.
    Downwards,
}

impl From<&Statistic> for Drift {
    fn from(of: &Statistic) -> Self {
        match (of.drifts, of.drift < 0.0) {
            (false, _) => Self::None,
            (true, false) => Self::Upwards,
            (true, true) => Self::Downwards,
        }
    }
}

impl<'a> Comparison<'a> {
    /// The answers of a run.
    pub fn of(summary: &'a Summary, units: UnitSet) -> Self {
        let scalars = scalars_by_row();
        let columns = summary.operations.iter().map(|solved| ComparedColumn {
            operation: &solved.operation,
            model: solved.model,
            is_complete: solved.status == Status::Complete,
            values: scalars
                .iter()
                .map(|of| Some(shown(of.quantity.kind, (of.of)(&solved.scalars)?, units)))
                .collect(),
            deviations: solved.statistics.as_ref().map(|statistics| {
                let of = scalars.iter().map(|of| {
                    let statistic = statistics.get(of.quantity.name)?;
                    let std = shown(of.quantity.kind, statistic.std, units);
                    Some(Deviation { std, drift: statistic.into() })
                });
                of.collect()
            }),
        });
        let columns: Vec<ComparedColumn> = columns.collect();
        let rows = scalars.iter().map(|scalar| {
            let alike = (0..scalars.len())
                .filter(|row| scalars[*row].quantity.kind == scalar.quantity.kind);
            ComparedRow {
                label: scalar.label,
                symbol: symbol(scalar.quantity.kind, units),
                decimals: decimals(
                    alike.flat_map(|row| columns.iter().filter_map(move |of| of.values[row])),
                ),
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
