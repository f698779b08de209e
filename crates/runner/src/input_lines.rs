//! Inputs and scalars as lines of a sheet.

use wholestring_report::{Cell, Cells, PageTable, Sheet, SheetColumn, display_unit};
use wholestring_units::{UnitSet, without_trailing_zeros};

/// Longer lists, such as the stations of a survey, are shown as a count.
const MAX_ITEMS: usize = 40;

/// A sheet of inputs: part of the case, name and value in each row.
pub(crate) fn inputs_of(about: &str, rows: Vec<[String; 3]>) -> Sheet {
    line_sheet(
        "Inputs",
        about,
        [
            ("table", "Part of the case"),
            ("input", "Name of the input, or of the item of a list"),
            ("value", "Its value, with its unit"),
        ],
        &rows,
    )
}

/// A sheet of three columns of words: their headings with meanings.
pub(crate) fn line_sheet(
    name: &str,
    about: &str,
    columns: [(&str, &str); 3],
    rows: &[[String; 3]],
) -> Sheet {
    let words = |(place, (heading, meaning)): (usize, (&str, &str))| SheetColumn {
        heading: heading.to_owned(),
        unit: String::new(),
        meaning: meaning.to_owned(),
        cells: Cells::Words(rows.iter().map(|row| row[place].clone()).collect()),
    };
    Sheet {
        name: name.to_owned(),
        about: about.to_owned(),
        columns: columns.into_iter().enumerate().map(words).collect(),
    }
}

/// Lines of a table, one for each input or list item.
pub(crate) fn lines(table: &PageTable, units: UnitSet) -> Vec<[String; 3]> {
    let title = || table.title.clone();
    if table.heads.is_empty() {
        let line = |row: &Vec<Cell>| {
            let [name, value] = &row[..] else { return None };
            Some([title(), text(name, units)?, text(value, units)?])
        };
        return table.rows.iter().filter_map(line).collect();
    }
    if table.rows.len() > MAX_ITEMS {
        return vec![[title(), "rows".to_owned(), table.rows.len().to_string()]];
    }
    let line = |(place, row): (usize, &Vec<Cell>)| {
        let value = |(head, cell): (&String, &Cell)| Some(format!("{head} {}", text(cell, units)?));
        let is_named = matches!(row.first(), Some(Cell::Text(_)));
        let name = row.first().filter(|_| is_named).and_then(|cell| text(cell, units));
        let values = table.heads.iter().zip(row).skip(usize::from(is_named));
        let values: Vec<String> = values.filter_map(value).collect();
        [title(), name.unwrap_or_else(|| (place + 1).to_string()), values.join("; ")]
    };
    table.rows.iter().enumerate().map(line).collect()
}

/// A value with its unit; `None` for an empty cell.
fn text(cell: &Cell, units: UnitSet) -> Option<String> {
    let quantities = |values: &[f64], dimension: &str| {
        let unit = display_unit(dimension, units);
        let factor = unit.as_ref().map_or(1.0, |unit| unit.factor);
        let numbers: Vec<String> = values.iter().map(|value| number(value / factor)).collect();
        let symbol = unit.map(|unit| unit.symbol).filter(|symbol| !symbol.is_empty());
        let numbers = numbers.join(", ");
        symbol.map_or_else(|| numbers.clone(), |symbol| format!("{numbers} {symbol}"))
    };
    match cell {
        Cell::Quantity { value, dimension, .. } => Some(quantities(&[*value], dimension)),
        Cell::Quantities { values, dimension } => Some(quantities(values, dimension)),
        Cell::Number(value) => Some(number(*value)),
        Cell::Link { text, .. } | Cell::Text(text) => {
            Some(text.clone()).filter(|it| !it.is_empty())
        }
        Cell::Nothing => None,
    }
}

/// A number in six digits, without trailing zeros.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.5e}");
    let exponent = scientific.rsplit_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    let Some(exponent @ -4..9) = exponent else { return scientific };
    let decimals = (5 - exponent).max(0) as usize;
    let text = format!("{value:.decimals$}");
    without_trailing_zeros(&text).to_owned()
}
