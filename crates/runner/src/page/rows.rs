//! Rows of a table on the page.

use std::collections::BTreeMap;

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_report::Packed;
use wholestring_results::Table;

use crate::column::{numbers, words};

/// Largest number of rows of a profile on the page; longer soft-string profiles are thinned.
const MAX_NODES: usize = 3000;

/// Rows of a table that belong to an operation, and to a model if the table distinguishes models.
pub(super) fn rows(
    table: &Table,
    model: Option<ModelKind>,
    operation: OperationKind,
) -> Vec<usize> {
    let models = words(table, "model");
    let operations = words(table, "operation").iter().enumerate();
    operations
        .filter(|(row, name)| {
            // A table without a column of models belongs to the time-domain model.
            let models = models.get(*row);
            let others = models.zip(model).is_some_and(|(own, model)| own != model.name());
            *name == operation.name() && !others
        })
        .map(|(row, _)| row)
        .collect()
}

/// Numbers of those rows by the name of their column; columns without numbers are left out.
pub(super) fn columns(
    table: &Table,
    model: Option<ModelKind>,
    operation: OperationKind,
) -> BTreeMap<String, Packed> {
    let rows = rows(table, model, operation);
    let step = rows.len().div_ceil(MAX_NODES).max(1);
    // The last row, that of the bit, is always included.
    let last = rows.len().saturating_sub(1);
    let chosen: Vec<usize> = rows
        .iter()
        .enumerate()
        .filter(|(place, _)| (last - place).is_multiple_of(step))
        .map(|(_, row)| *row)
        .collect();
    let names = table.columns().iter().map(|column| column.name.as_str());
    names
        .filter_map(|name| {
            let all = numbers(table, name);
            let values: Vec<f64> = chosen
                .iter()
                .map(|row| all.get(*row).copied().flatten().unwrap_or(f64::NAN))
                .collect();
            let any = values.iter().any(|value| value.is_finite());
            any.then(|| (name.to_owned(), Packed::single(values)))
        })
        .collect()
}
