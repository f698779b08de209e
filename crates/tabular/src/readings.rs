//! From rows of numbers to readings at the surface.

use crate::{
    cells::number::Style,
    cells::table::{Row, Table},
    columns::column::Column,
    columns::layout::Layout,
    columns::sort::READINGS,
    error::{TableError, TableErrorKind},
    survey::reader::{Reader, style, whole},
    survey::stations::data_rows,
};

/// No hole is deeper along its axis, m.
const DEEPEST_M: f64 = 1e5;

/// What was read with the bit at a depth.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedReading {
    /// Where it stands in its file: `line 3`, `row 3 of sheet 'weights'`.
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
    /// Density of the mud, kg/m³, where it is not that of the case.
    pub mud_density_kg_per_m3: Option<f64>,
    /// The case that it belongs to, where there are several.
    pub case: Option<String>,
    /// It is only held against what the others tell: its `use` is "no".
    pub held_out: bool,
    /// Keys of the case that its row changes, each with its value and unit.
    pub keys: Vec<(String, String)>,
}

/// Readings and how they were understood.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedReadings {
    /// By their order in the file.
    pub readings: Vec<ImportedReading>,
    /// What was recognised and passed over, in sentences for people.
    pub notes: Vec<String>,
}

/// Reads the rows below the header.
pub(crate) fn read(table: &Table, layout: Layout) -> Result<ImportedReadings, TableError> {
    let mut notes = layout.notes.clone();
    let none = |found| TableErrorKind::NoReadings { found };
    let measured = [
        Column::PickUp,
        Column::SlackOff,
        Column::Rotating,
        Column::Torque,
        Column::TorqueOnBottom,
    ];
    let Some(depth) = layout.column(Column::BitDepth) else {
        return Err(table.source.error(none("no column is the bit's depth"), None));
    };
    if measured.iter().all(|column| layout.column(*column).is_none()) {
        let at = table.rows.get(layout.data.saturating_sub(1)).map(whole);
        return Err(table.source.error(none("no column is a weight or a torque"), at));
    }
    let rows = data_rows(table, &layout, &READINGS, &mut notes);
    let reader = Reader { table, style: style(table, &layout, &rows)? };
    if reader.style == Style::Comma {
        notes.push("a comma is read as the decimal sign".to_owned());
    }
    let keys = keys(&layout, &mut notes);
    let read: Vec<usize> = keys.iter().map(|key| key.index).collect();
    table.check_calculated(&read, layout.data)?;
    let mut readings = Vec::new();
    for &row in &rows {
        let row = &table.rows[row];
        if let Some(expected) = table.counted.filter(|&count| row.cells.len() < count) {
            let kind = TableErrorKind::ShortRow { found: row.cells.len(), expected };
            return Err(table.source.error(kind, Some(whole(row))));
        }
        let maybe = |column: Column| match layout.column(column) {
            Some(found) if !is_blank(row.text(found.index)) => reader.value(row, found).map(Some),
            _ => Ok(None),
        };
        let bit_depth_m = reader.value(row, depth)?;
        if !(bit_depth_m > 0.0 && bit_depth_m <= DEEPEST_M) {
            return Err(reader.out_of_range(row, depth, "more than 0, to 100 km"));
        }
        let mud_density_kg_per_m3 = maybe(Column::MudDensity)?;
        if let (Some(density), Some(found)) =
            (mud_density_kg_per_m3, layout.column(Column::MudDensity))
            && !(0.0..=4000.0).contains(&density)
        {
            return Err(reader.out_of_range(row, found, "0 to 4 sg"));
        }
        let held_out = match layout.column(Column::Use).map(|found| row.text(found.index)) {
            None | Some("") => false,
            Some(word) => match word.to_ascii_lowercase().as_str() {
                "yes" => false,
                "no" => true,
                _ => {
                    let kind = TableErrorKind::NotYesNo { found: word.to_owned() };
                    let at =
                        layout.column(Column::Use).and_then(|found| row.cells.get(found.index));
                    return Err(table.source.error(kind, at.map(|cell| cell.at)));
                }
            },
        };
        let case = layout.column(Column::Case).map(|found| row.text(found.index));
        readings.push(ImportedReading {
            place: table.source.row_name(whole(row)),
            bit_depth_m,
            pick_up_N: maybe(Column::PickUp)?,
            slack_off_N: maybe(Column::SlackOff)?,
            rotating_N: maybe(Column::Rotating)?,
            torque_N_m: maybe(Column::Torque)?,
            torque_on_bottom_N_m: maybe(Column::TorqueOnBottom)?,
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
    notes.push(format!("{} rows", readings.len()));
    Ok(ImportedReadings { readings, notes })
}

/// A column that is a key of the case.
struct Key {
    index: usize,
    name: String,
    /// Unit in its heading, as it is written.
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

    /// What a row says of it; nothing where its cell is empty.
    fn of(&self, row: &Row) -> Option<(String, String)> {
        let text = row.text(self.index);
        let value = format!("{text} {}", self.unit);
        (!is_blank(text)).then(|| (self.name.clone(), value.trim().to_owned()))
    }
}

/// The columns that are keys of the case; those that are nothing are noted.
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

/// An empty cell, or a dash in place of a number.
fn is_blank(text: &str) -> bool {
    text.chars().all(|c| "-–—".contains(c))
}
