//! Tables of results as sheets, in the units of people.

use wholestring_report::{Cells, DisplayUnit, Sheet, SheetColumn, operation_name};
use wholestring_results::{Column, Data, Table};
use wholestring_units::UnitSet;

use crate::page::dimensions::{of_setting, pretty, unit};

/// A table in these units; its name is that of its tab, 31 letters at most.
pub(crate) fn sheet(name: &str, table: &Table, about: &str, units: UnitSet) -> Sheet {
    let rows = row_units(table, units);
    let columns = table.columns().iter().map(|of| column(of, rows.as_deref(), units)).collect();
    Sheet { name: name.to_owned(), about: about.to_owned(), columns }
}

/// Columns whose unit is that of their row.
const OF_ROWS: [&str; 2] = ["load", "capacity"];

/// SI units that rows name, and what they are of.
const ROW_UNITS: [(&str, &str); 3] = [("N", "force"), ("N·m", "torque"), ("Pa", "pressure")];

/// The reader's unit of each row of a table whose rows name theirs.
fn row_units(table: &Table, units: UnitSet) -> Option<Vec<DisplayUnit>> {
    let shown = |si: &String| {
        let dimension = ROW_UNITS.iter().find(|(symbol, _)| symbol == si).map_or("", |of| of.1);
        unit(dimension, units).unwrap_or(DisplayUnit { symbol: si.clone(), factor: 1.0 })
    };
    Some(table.words("unit")?.iter().map(shown).collect())
}

/// What lies across a wall is as small as a diameter.
const ACROSS: [&str; 3] = ["groove_m", "wall_m", "wall_left_m"];

/// A column in the reader's units, which stand in its heading, or in the rows' own.
fn column(of: &Column, rows: Option<&[DisplayUnit]>, units: UnitSet) -> SheetColumn {
    let found = match of.name.strip_suffix("_m") {
        Some(stem) if ACROSS.contains(&of.name.as_str()) => Some(("diameter", stem)),
        _ => of_setting(&of.name),
    };
    let (dimension, stem) = found.filter(|_| !of.unit.is_empty()).unwrap_or(("", &of.name));
    let shown = unit(dimension, units);
    let all = shown.as_ref().map_or(1.0, |of| of.factor);
    let rows = rows.filter(|_| OF_ROWS.contains(&of.name.as_str()) || of.name == "unit");
    let factor = |row: usize| rows.and_then(|units| units.get(row)).map_or(all, |of| of.factor);
    let cells = match (&of.data, rows) {
        (Data::Number(values), _) => {
            let values = values.iter().enumerate();
            Cells::Numbers(values.map(|(row, value)| Some((*value)? / factor(row))).collect())
        }
        (Data::Text(_), Some(units)) => {
            Cells::Words(units.iter().map(|of| of.symbol.clone()).collect())
        }
        (Data::Text(words), None) => {
            Cells::Words(words.iter().map(|word| readable(of, word)).collect())
        }
    };
    SheetColumn {
        heading: stem.replace('_', " "),
        unit: shown.map_or_else(|| pretty(&of.unit), |of| of.symbol),
        meaning: of.meaning.replace('`', ""),
        cells,
    }
}

/// Operations as drillers call them; other words as they are.
fn readable(of: &Column, word: &str) -> String {
    match of.name.as_str() {
        "operation" => operation_name(word).to_owned(),
        "worst_finding" | "event" => word.replace('_', " "),
        _ => word.to_owned(),
    }
}
