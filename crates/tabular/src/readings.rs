//! Converts rows of numbers to readings at the surface.

use wholestring_units::Unit;

use crate::{
    cells::{
        number::{Style, is_null, is_null_word},
        table::{Row, Table},
    },
    columns::{
        column::Column,
        layout::{Found, Layout},
        names::READINGS,
    },
    error::{TableError, TableErrorKind},
    row_names::row_names,
    survey::{
        reader::{Reader, style, whole},
        stations::data_rows,
    },
};

/// Maximum measured depth of a hole, m.
const DEEPEST_M: f64 = 1e5;

/// Maximum density of a mud, as of the case's key, kg/m³.
const DENSEST_KG_PER_M3: f64 = 3000.0;

/// Numbers beyond this are no weights, N, and no torques, N·m, in any unit of their heading.
const LARGEST_SI: f64 = 1e13;

/// The measured columns: weights, then torques.
const MEASURED: [Column; 5] =
    [Column::PickUp, Column::SlackOff, Column::Rotating, Column::Torque, Column::TorqueOnBottom];

/// Readings with the bit at a depth.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedReading {
    /// Its place in the file: `line 3`, `row 3 of sheet 'weights'`.
    pub place: String,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Hook load while the string is pulled out, N.
    pub pick_up_N: Option<f64>,
    /// Hook load while it is run in, N.
    pub slack_off_N: Option<f64>,
    /// Hook load while it turns off bottom, N.
    pub rotating_N: Option<f64>,
    /// Torque off bottom, N·m.
    pub torque_N_m: Option<f64>,
    /// Torque on bottom, N·m.
    pub torque_on_bottom_N_m: Option<f64>,
    /// Density of the mud, kg/m³, if it differs from that of the case.
    pub mud_density_kg_per_m3: Option<f64>,
    /// The case to which it belongs, if there are several.
    pub case: Option<String>,
    /// Whether it is excluded from calibration and only compared with its result: its `use` is
    /// "no", "false" or 0.
    pub held_out: bool,
    /// Keys of the case that its row changes, each with its value and unit.
    pub keys: Vec<(String, String)>,
}

/// Readings and notes on their interpretation.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedReadings {
    /// In the order of the file.
    pub readings: Vec<ImportedReading>,
    /// Notes on what was recognised and skipped.
    pub notes: Vec<String>,
    /// Half of the last digit of bit depths, m, which is the possible error of a depth.
    pub half_digit_m: f64,
    /// Units of the pick-up, slack-off and rotating weights, and of the torques off and on bottom.
    pub units: [Option<&'static Unit>; 5],
}

/// Reads the rows below the header.
pub(crate) fn read(table: &Table, layout: Layout) -> Result<ImportedReadings, TableError> {
    let mut notes = layout.notes.clone();
    let none = |found| TableErrorKind::NoReadings { found };
    let Some(depth) = layout.column(Column::BitDepth) else {
        return Err(table.source.error(none("no column is the bit's depth"), None));
    };
    if MEASURED.iter().all(|column| layout.column(*column).is_none()) {
        let at = table.rows.get(layout.data.saturating_sub(1)).map(whole);
        return Err(table.source.error(none("no column is a weight or a torque"), at));
    }
    let rows = data_rows(table, &layout, &READINGS, &mut notes)?;
    let reader = Reader { table, style: style(table, &layout, &rows)? };
    if reader.style == Style::Comma {
        notes.push("a comma is read as the decimal sign".to_owned());
    }
    let keys = keys(&layout, &mut notes);
    let read: Vec<usize> = keys.iter().map(|key| key.index).collect();
    table.check_calculated(&read, layout.data)?;
    let mut readings = Vec::new();
    let mut nulls = Nulls::default();
    let mut half_digit_m = f64::INFINITY;
    for &row in &rows {
        let row = &table.rows[row];
        if let Some(expected) = table.counted.filter(|&count| row.cells.len() < count) {
            let kind = TableErrorKind::ShortRow { found: row.cells.len(), expected };
            return Err(table.source.error(kind, Some(whole(row))));
        }
        table.check_width(row, &layout.header, |index| layout.is_of_numbers(index))?;
        let place = table.source.row_name(whole(row));
        let mut maybe = |column: Column| match layout.column(column) {
            Some(found) if nulls.hold(&reader, row, found, &place) => Ok(None),
            Some(found) if !is_blank(row.text(found.index)) => reader.value(row, found).map(Some),
            _ => Ok(None),
        };
        if maybe(Column::BitDepth)?.is_none() && !is_blank(row.text(depth.index)) {
            continue;
        }
        let bit_depth_m = reader.value(row, depth)?;
        half_digit_m = half_digit_m.min(half_digit(row.text(depth.index), reader.style, depth));
        if !(bit_depth_m > 0.0 && bit_depth_m <= DEEPEST_M) {
            return Err(reader.out_of_range(row, depth, "more than 0, to 100 km"));
        }
        let mud_density_kg_per_m3 = maybe(Column::MudDensity)?;
        if let (Some(density), Some(found)) =
            (mud_density_kg_per_m3, layout.column(Column::MudDensity))
            && !(0.0..=DENSEST_KG_PER_M3).contains(&density)
        {
            return Err(reader.out_of_range(row, found, "0 to 3 sg"));
        }
        let held_out = match layout.column(Column::Use).map(|found| row.text(found.index)) {
            None | Some("") => false,
            Some(word) => match word.to_ascii_lowercase().as_str() {
                "yes" | "y" | "true" | "1" => false,
                "no" | "n" | "false" | "0" => true,
                _ => {
                    let kind = TableErrorKind::NotYesNo { found: word.to_owned() };
                    let at =
                        layout.column(Column::Use).and_then(|found| row.cells.get(found.index));
                    return Err(table.source.error(kind, at.map(|cell| cell.at)));
                }
            },
        };
        let case = layout.column(Column::Case).map(|found| row.text(found.index));
        let mut values = [None; MEASURED.len()];
        for (value, column) in values.iter_mut().zip(MEASURED) {
            *value = maybe(column)?;
            if let (Some(value), Some(found)) = (*value, layout.column(column))
                && value.abs() > LARGEST_SI
            {
                return Err(reader.out_of_range(
                    row,
                    found,
                    "less than 1e13 N or N.m; a null value is an empty cell",
                ));
            }
        }
        let [pick_up_N, slack_off_N, rotating_N, torque_N_m, torque_on_bottom_N_m] = values;
        readings.push(ImportedReading {
            place,
            bit_depth_m,
            pick_up_N,
            slack_off_N,
            rotating_N,
            torque_N_m,
            torque_on_bottom_N_m,
            mud_density_kg_per_m3,
            case: case.filter(|case| !case.is_empty()).map(str::to_owned),
            held_out,
            keys: keys.iter().filter_map(|key| key.of(row)).collect(),
        });
    }
    if readings.is_empty() {
        let at = table.rows.get(layout.data.saturating_sub(1)).map(whole);
        return Err(table.source.error(none("no row follows the header"), at));
    }
    notes.extend(table.notes.iter().cloned());
    notes.extend(nulls.notes());
    notes.push(format!("{} rows", readings.len()));
    let units = MEASURED.map(|column| layout.column(column).map(|found| found.unit));
    Ok(ImportedReadings { readings, notes, half_digit_m, units })
}

/// Half of the last digit of a depth as written, m.
fn half_digit(text: &str, style: Style, depth: &Found) -> f64 {
    let sign = if style == Style::Comma { ',' } else { '.' };
    let digits = |rest: &str| rest.chars().take_while(char::is_ascii_digit).count();
    let decimals = text.split_once(sign).map_or(0, |(_, rest)| digits(rest));
    0.5 * 10_f64.powi(-(decimals.min(9) as i32)) * depth.unit.factor
}

/// Null values that a database or a logger writes in place of a number.
#[derive(Default)]
struct Nulls {
    /// Column, text and the rows with it.
    found: Vec<(Column, String, Vec<String>)>,
}

impl Nulls {
    /// Whether a cell is a null value; if so, it is recorded.
    fn hold(&mut self, reader: &Reader, row: &Row, found: &Found, place: &str) -> bool {
        let Some(cell) = row.cells.get(found.index).filter(|cell| !cell.is_empty()) else {
            return false;
        };
        let number = reader.read(cell, found.column).ok();
        let is_null = match number {
            Some(number) => is_null(number),
            None => is_null_word(&cell.text),
        };
        if is_null {
            let same = |column: &&mut (Column, String, Vec<String>)| {
                column.0 == found.column && column.1 == cell.text
            };
            match self.found.iter_mut().find(same) {
                Some((_, _, places)) => places.push(place.to_owned()),
                None => {
                    let places = vec![place.to_owned()];
                    self.found.push((found.column, cell.text.clone(), places));
                }
            }
        }
        is_null
    }

    fn notes(&self) -> impl Iterator<Item = String> {
        self.found.iter().map(|(column, text, places)| {
            let rows = row_names(places);
            match column {
                Column::BitDepth => format!(
                    "{rows}: left out, because the bit depth is '{text}', which is a null value"
                ),
                _ => {
                    format!("{rows}: the {column} is '{text}', which is a null value: left out")
                }
            }
        })
    }
}

/// A column that is a key of the case.
struct Key {
    index: usize,
    name: String,
    /// Unit in its heading, as written.
    unit: String,
}

impl Key {
    /// The key that a heading names: words with dots between them, as `string.2.length (ft)`.
    fn named(index: usize, heading: &str) -> Option<Self> {
        let (name, rest) = heading.split_once(['(', '[']).unwrap_or((heading, ""));
        let (name, unit) = (name.trim(), rest.trim_end_matches([')', ']']).trim());
        let is_part = |part: &str| {
            !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        };
        let begins = name.starts_with(|c: char| c.is_ascii_lowercase());
        (begins && name.contains('.') && name.split('.').all(is_part)).then(|| Self {
            index,
            name: name.to_owned(),
            unit: unit.to_owned(),
        })
    }

    /// Value of the key in a row; `None` if its cell is empty.
    fn of(&self, row: &Row) -> Option<(String, String)> {
        let text = row.text(self.index);
        let value = format!("{text} {}", self.unit);
        (!is_blank(text)).then(|| (self.name.clone(), value.trim().to_owned()))
    }
}

/// The columns that are keys of the case; unknown ones are noted.
fn keys(layout: &Layout, notes: &mut Vec<String>) -> Vec<Key> {
    let mut keys = Vec::new();
    for (index, text) in layout.header.iter().enumerate() {
        if text.is_empty() || layout.columns.iter().any(|found| found.index == index) {
            continue;
        }
        match Key::named(index, text) {
            Some(key) => {
                notes.push(format!("`{}` of the case from '{text}'", key.name));
                keys.push(key);
            }
            None => notes.push(format!("the column '{text}' is not used")),
        }
    }
    keys
}

/// Whether a cell is empty, or a dash in place of a number.
fn is_blank(text: &str) -> bool {
    text.chars().all(|c| "-–—".contains(c))
}
