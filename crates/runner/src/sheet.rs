//! Tables of results as sheets, in the units of people.

use wholestring_report::{Cells, DisplayUnit, Sheet, SheetColumn, operation_name};
use wholestring_results::{Column, Data, Table};
use wholestring_units::{Dimension, UnitSet};

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

/// Dimension and name of a column whose unit is one that more than the end of its name tells: of
/// `wear_work_J_per_m` no length. None in whose units people see it stay as they are.
fn of_unit(of: &Column) -> Option<(&'static str, &str)> {
    let suffix = of.unit.replace(['·', '.'], "_").replace('/', "_per_");
    let stem = of.name.strip_suffix(&suffix)?.strip_suffix('_')?;
    let by_name = of_setting(&of.name)?;
    if stem.len() >= by_name.1.len() {
        return None;
    }
    let is_its = |dimension: &&Dimension| pretty(dimension.si_symbol()) == pretty(&of.unit);
    Some((Dimension::ALL.iter().find(is_its).map_or("", |dimension| dimension.name()), stem))
}

/// A column in the reader's units, which stand in its heading, or in the rows' own.
fn column(of: &Column, rows: Option<&[DisplayUnit]>, units: UnitSet) -> SheetColumn {
    let found = match of.name.strip_suffix("_m") {
        Some(stem) if ACROSS.contains(&of.name.as_str()) => Some(("diameter", stem)),
        _ => of_unit(of).or_else(|| of_setting(&of.name)),
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

/// Operations and checks in words; other words as they are.
fn readable(of: &Column, word: &str) -> String {
    match of.name.as_str() {
        "operation" => operation_name(word),
        "worst_check" | "event" => word.replace('_', " "),
        _ => word.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A unit that is longer than the one at the end of the name: no metres of work.
    #[test]
    fn a_column_is_shown_in_a_unit_of_its_own() {
        let table = |name: &str, unit: &str| {
            Table::new(vec![Column {
                name: name.to_owned(),
                unit: unit.to_owned(),
                meaning: String::new(),
                data: Data::Number(vec![Some(1.0)]),
            }])
        };
        let shown = |name: &str, unit: &str| {
            let sheet = sheet("S", &table(name, unit), "", UnitSet::Field);
            let Cells::Numbers(values) = &sheet.columns[0].cells else { panic!("{name}") };
            (sheet.columns[0].head(), values[0].unwrap())
        };
        assert_eq!(shown("wear_work_J_per_m", "J/m"), ("wear work, J/m".to_owned(), 1.0));
        let torque = shown("friction_torque_N_m_per_m", "N·m/m");
        assert_eq!(torque, ("friction torque, N·m/m".to_owned(), 1.0));
        let (head, severity) = shown("dogleg_severity_rad_per_m", "rad/m");
        assert_eq!(head, "dogleg severity, °/100 ft");
        assert!((severity - 30.48_f64.to_degrees()).abs() < 1e-9);
        assert_eq!(shown("md_m", "m"), ("md, ft".to_owned(), 1.0 / 0.3048));
        assert_eq!(shown("side_force_N_per_m", "N/m").0, "side force, lbf/ft");
        assert_eq!(shown("hook_load_N", "N").0, "hook load, klbf");
    }
}
