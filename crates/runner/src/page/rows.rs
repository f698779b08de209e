//! The rows of a table that a page shows.

use std::collections::BTreeMap;

use wholestring_report::Packed;
use wholestring_results::Table;

use crate::column::{numbers, words};

/// Rows of a profile that a page shows: of a soft string every few where there are more.
const MAX_NODES: usize = 3000;

/// Rows of a table that belong to an operation, and to a model where the table distinguishes them.
pub(super) fn rows(table: &Table, model: Option<&str>, operation: &str) -> Vec<usize> {
    let models = words(table, "model");
    let operations = words(table, "operation").iter().enumerate();
    operations
        .filter(|(row, name)| {
            // A table that does not distinguish models is that of the one in time.
            let of = models.get(*row);
            let others = of.zip(model).is_some_and(|(of, model)| of != model);
            *name == operation && !others
        })
        .map(|(row, _)| row)
        .collect()
}

/// The numbers of those rows by the name of their column; columns that hold none are left out.
pub(super) fn columns(
    table: &Table,
    model: Option<&str>,
    operation: &str,
) -> BTreeMap<String, Packed> {
    let rows = rows(table, model, operation);
    let step = rows.len().div_ceil(MAX_NODES).max(1);
    // The last row, the bit's, is always among them.
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
