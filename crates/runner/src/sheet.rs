//! Tables of results as sheets, in display units, and inputs and scalars as lines of a sheet.

use wholestring_case::dimension_at;
use wholestring_judge::{CheckKind, DepthLimit};
use wholestring_report::{
    Cell, Cells, DisplayUnit, PageTable, Sheet, SheetColumn, display_unit, pretty_symbol,
    reading_words, setting_dimension,
};
use wholestring_results::{Column, Data, PlanOperation, Table};
use wholestring_units::{Dimension, UnitSet, without_trailing_zeros};

/// A table in these units; its name is limited to the 31 letters of a sheet's tab.
pub(crate) fn sheet(name: &str, table: &Table, about: &str, units: UnitSet) -> Sheet {
    let rows = row_units(table, units);
    let columns =
        table.columns().iter().map(|source| column(source, rows.as_deref(), units)).collect();
    Sheet { name: name.to_owned(), about: about.to_owned(), columns }
}

/// Columns whose unit is given for each row.
const OF_ROWS: [&str; 2] = ["load", "capacity"];

/// Display unit of each row, for a table of checks, each with its unit: that of the kind of check.
fn row_units(table: &Table, units: UnitSet) -> Option<Vec<DisplayUnit>> {
    let unit_of_row = |(kind, si): (&String, &String)| {
        let dimension = CheckKind::named(kind).map_or("", |kind| kind.quantity().dimension());
        display_unit(dimension, units).unwrap_or(DisplayUnit { symbol: si.clone(), factor: 1.0 })
    };
    Some(table.words("kind")?.iter().zip(table.words("unit")?).map(unit_of_row).collect())
}

/// Dimensions of a wall, which are as small as a diameter.
const ACROSS: [&str; 3] = ["groove_m", "wall_m", "wall_left_m"];

/// Dimension and name of a column whose unit does not follow from the end of its name alone: that
/// of `wear_work_J_per_m` is not a length. `None` if the column is shown in its own unit.
fn of_unit(column: &Column) -> Option<(&'static str, &str)> {
    let suffix = column.unit.replace(['·', '.'], "_").replace('/', "_per_");
    let stem = column.name.strip_suffix(&suffix)?.strip_suffix('_')?;
    let by_name = setting_dimension(&column.name)?;
    if stem.len() >= by_name.1.len() {
        return None;
    }
    let is_its = |dimension: &&Dimension| {
        pretty_symbol(dimension.si_symbol()) == pretty_symbol(&column.unit)
    };
    Some((Dimension::ALL.iter().find(is_its).map_or("", |dimension| dimension.name()), stem))
}

/// Dimension and name of a column that holds the error or the deviation of another one, which has the
/// unit of that one: that of a rate of penetration is a rate, not a speed.
fn of_spread(name: &str) -> Option<(&'static str, String)> {
    ["_error", "_std"].into_iter().find_map(|spread| {
        let (before, after) = name.split_once(&format!("{spread}_"))?;
        let plain = format!("{before}_{after}");
        let (dimension, stem) = setting_dimension(&plain)?;
        Some((dimension, format!("{stem}{spread}")))
    })
}

/// Dimension and name of a column of a varied key, such as `wob`.
fn of_key(column: &Column) -> Option<(&'static str, String)> {
    let dimension = dimension_at(&column.name)?;
    (dimension.si_symbol() == column.unit).then(|| (dimension.name(), column.name.clone()))
}

/// A column in display units, which are in its heading, or in those of the rows.
fn column(column: &Column, rows: Option<&[DisplayUnit]>, units: UnitSet) -> SheetColumn {
    let found = match column.name.strip_suffix("_m") {
        Some(stem) if ACROSS.contains(&column.name.as_str()) => Some(("diameter", stem.to_owned())),
        _ => of_unit(column).map(|(dimension, stem)| (dimension, stem.to_owned())),
    };
    let found = found
        .or_else(|| of_spread(&column.name))
        .or_else(|| {
            setting_dimension(&column.name).map(|(dimension, stem)| (dimension, stem.to_owned()))
        })
        .or_else(|| of_key(column));
    let (dimension, stem) =
        found.filter(|_| !column.unit.is_empty()).unwrap_or(("", column.name.clone()));
    let unit = display_unit(dimension, units);
    let all = unit.as_ref().map_or(1.0, |unit| unit.factor);
    let rows = rows.filter(|_| OF_ROWS.contains(&column.name.as_str()) || column.name == "unit");
    let factor = |row: usize| rows.and_then(|units| units.get(row)).map_or(all, |unit| unit.factor);
    let cells = match (&column.data, rows) {
        (Data::Number(values), _) => {
            let values = values.iter().enumerate();
            Cells::Numbers(values.map(|(row, value)| Some((*value)? / factor(row))).collect())
        }
        (Data::Text(_), Some(units)) => {
            Cells::Words(units.iter().map(|unit| unit.symbol.clone()).collect())
        }
        (Data::Text(words), None) => {
            Cells::Words(words.iter().map(|word| readable(column, word)).collect())
        }
    };
    SheetColumn {
        heading: heading(&stem),
        unit: unit.map_or_else(|| pretty_symbol(&column.unit), |unit| unit.symbol),
        meaning: column.meaning.replace('`', ""),
        cells,
    }
}

/// Heading of a column without its unit.
fn heading(stem: &str) -> String {
    match stem {
        "along" => "axial friction".to_owned(),
        "around" => "rotational friction".to_owned(),
        "md" => "measured depth".to_owned(),
        other => other.replace("von_mises", "von Mises").replace('_', " "),
    }
}

/// An operation or an event in words; other names, as that of a bit test, with spaces.
pub(crate) fn operation_words(name: &str) -> String {
    let found = PlanOperation::from_name(name);
    found.map_or_else(|| name.replace('_', " "), |operation| operation.words().to_owned())
}

/// Readable names of operations, checks, limits and readings; other words are unchanged.
fn readable(column: &Column, word: &str) -> String {
    let of_kind = || CheckKind::named(word).map(|kind| kind.label().to_owned());
    let spaced = || word.replace('_', " ");
    match column.name.as_str() {
        "operation" => operation_words(word),
        "limit" => {
            // Its present name alone: `lock_up`, an earlier one, is a limit of plans.
            let limit = DepthLimit::ALL.iter().find(|limit| limit.name() == word);
            limit.map_or_else(spaced, |limit| limit.title().to_owned())
        }
        "reading" => reading_words(word).to_owned(),
        "kind" | "worst_check" => of_kind().unwrap_or_else(spaced),
        "event" | "varied" | "quantity" => spaced(),
        _ => word.to_owned(),
    }
}

// Inputs and scalars as lines of a sheet.

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

#[cfg(test)]
mod tests {
    use wholestring_results::TABLES;

    use super::*;

    /// A unit that is longer than the one at the end of the name: the work is not a length.
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
        let head_and_value = |name: &str, unit: &str| {
            let sheet = sheet("S", &table(name, unit), "", UnitSet::Field);
            let Cells::Numbers(values) = &sheet.columns[0].cells else { panic!("{name}") };
            (sheet.columns[0].head(), values[0].unwrap())
        };
        assert_eq!(head_and_value("wear_work_J_per_m", "J/m"), ("wear work, J/m".to_owned(), 1.0));
        let torque = head_and_value("friction_torque_N_m_per_m", "N·m/m");
        assert_eq!(torque, ("friction torque, N·m/m".to_owned(), 1.0));
        let (head, severity) = head_and_value("dogleg_severity_rad_per_m", "rad/m");
        assert_eq!(head, "dogleg severity, °/100 ft");
        assert!((severity - 30.48_f64.to_degrees()).abs() < 1e-9);
        assert_eq!(head_and_value("md_m", "m"), ("measured depth, ft".to_owned(), 1.0 / 0.3048));
        assert_eq!(head_and_value("side_force_N_per_m", "N/m").0, "side force, lbf/ft");
        assert_eq!(head_and_value("hook_load_N", "N").0, "hook load, klbf");
        // The error of a rate has the unit of the rate.
        for name in ["rate_of_penetration", "rate_of_penetration_error"] {
            let (head, _) = head_and_value(&format!("{name}_m_per_s"), "m/s");
            assert_eq!(head, format!("{}, ft/h", name.replace('_', " ")));
        }
        // A varied key has the unit of its dimension.
        assert_eq!(head_and_value("wob", "N").0, "wob, klbf");
        assert_eq!(head_and_value("rpm", "rpm"), ("rpm, rpm".to_owned(), 1.0));
    }

    /// Engineers read stresses in MPa where they read pressures in bar.
    #[test]
    fn stresses_are_not_in_the_unit_of_pressures() {
        let declared = TABLES.iter().flat_map(|(_, columns)| columns.iter());
        let mut found = Vec::new();
        for spec in declared.filter(|spec| spec.unit == "Pa") {
            let dimension = setting_dimension(spec.name).map(|(dimension, _)| dimension);
            assert_eq!(dimension, Some(spec.kind.dimension()), "{}", spec.name);
            found.push(spec.kind.dimension());
        }
        assert!(found.contains(&"stress") && found.contains(&"pressure"), "{found:?}");

        let limits = Table::new(vec![
            Column::words("kind", ["von_mises", "pump_pressure"].map(str::to_owned).into()),
            Column::numbers("load", vec![Some(5e8), Some(2e7)]),
            Column::words("unit", vec!["Pa".to_owned(); 2]),
        ]);
        let sheet = sheet("S", &limits, "", UnitSet::Metric);
        assert_eq!(sheet.columns[1].cells, Cells::Numbers(vec![Some(500.0), Some(200.0)]));
        assert_eq!(sheet.columns[2].cells, Cells::Words(vec!["MPa".to_owned(), "bar".to_owned()]));
    }

    /// Headings have the field's words.
    #[test]
    fn headings_have_words_of_the_field() {
        for (name, expected) in [
            ("along", "axial friction"),
            ("around", "rotational friction"),
            ("von_mises_stress", "von Mises stress"),
        ] {
            assert_eq!(heading(name), expected);
        }
    }

    /// Kinds, limits and readings in words.
    #[test]
    fn words_of_a_sheet_are_those_of_the_field() {
        let cells = |name: &str, word: &str| {
            let table = Table::new(vec![Column::words(name, vec![word.to_owned()])]);
            sheet("S", &table, "", UnitSet::Si).columns[0].cells.clone()
        };
        for (name, word, expected) in [
            ("limit", "yield_strength", DepthLimit::Yield.title()),
            ("limit", "lock_up", "lock up"),
            ("reading", "pick_up", "pick-up"),
            ("kind", "make_up", CheckKind::MakeUp.label()),
            ("worst_check", "von_mises", CheckKind::VonMises.label()),
        ] {
            assert_eq!(cells(name, word), Cells::Words(vec![expected.to_owned()]), "{name}");
        }
    }
}
