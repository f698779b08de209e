//! Plotting conventions, which `wholestring.plot` would otherwise repeat.

use std::collections::BTreeMap;

use pyo3::prelude::*;
use serde_json::{Value as Json, json};
use wholestring::outcome::{Quantity, SCALARS, Values, WELL_PATH};
use wholestring_report::{Conventions, shown_dimension};
use wholestring_results::{Column, Data, TABLES, Table as StoredTable};
use wholestring_runner::{display_units, well_path as path_of};

use crate::{error, table::Table};

/// Colours, strokes and drawn columns; the units of every dimension in each set; title and
/// dimension of every column and scalar.
pub(crate) fn json(py: Python<'_>) -> PyResult<String> {
    let columns = TABLES.iter().flat_map(|(_, columns)| columns.iter());
    let path = WELL_PATH.iter().map(|column| &column.quantity);
    let scalars = SCALARS.iter().map(|scalar| &scalar.quantity);
    let mut quantities: BTreeMap<&str, (String, &str)> = BTreeMap::new();
    // The engine's title of a scalar takes precedence over that of a table.
    for scalar in scalars.chain(columns).chain(path) {
        quantities.entry(scalar.name).or_insert_with(|| about(scalar));
    }
    let all = json!({
        "pictures": Conventions::of_the_house(),
        "units": display_units(),
        "quantities": quantities,
    });
    serde_json::to_string(&all).map_err(|_| error::of_panic(py))
}

/// Title and dimension, empty for text.
fn about(quantity: &Quantity) -> (String, &'static str) {
    let dimension = if quantity.text { "" } else { shown_dimension(quantity.kind) };
    (quantity.label(), dimension)
}

/// The path from the surface to the bit.
pub(crate) fn well_path(settings_json: &str) -> PyResult<Table> {
    let settings: Json = serde_json::from_str(settings_json)
        .map_err(|error| error::bad_input(format!("invalid settings: {error}")))?;
    let path = path_of(&settings);
    let columns = WELL_PATH.iter().map(|column| {
        let data = match (column.of)(&path) {
            Values::Numbers(values) => Data::Number(values.iter().copied().map(Some).collect()),
            Values::Words(words) => Data::Text(words.iter().map(ToString::to_string).collect()),
        };
        let Quantity { name, unit, meaning, .. } = column.quantity;
        Column { name: name.into(), unit: unit.into(), meaning: meaning.into(), data }
    });
    Table::of(&StoredTable::new(columns.collect()))
}
