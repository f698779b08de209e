//! Visible contents of the sheets of a workbook: hidden rows and columns, and formulas whose
//! results were never calculated. The reader of workbooks reports neither.
//!
//! Some programs that write workbooks leave results out (`<f>` without `<v>`), or write 0 to be
//! calculated when the workbook is opened (`fullCalcOnLoad`).
//!
//! Format: ECMA-376 part 1, 18.2 (workbook) and 18.3 (worksheets).

use std::collections::BTreeSet;

use quick_xml::{
    Reader,
    events::{BytesStart, Event},
};

use crate::cells::{archive::Parts, limits};
use crate::error::TableErrorKind;

/// Maximum number of array formulas of a sheet whose ranges are stored.
const ARRAYS: usize = 64;

/// Visibility of the contents of a sheet.
#[derive(Debug, Default)]
pub(crate) struct Shown {
    /// Hidden rows, from 0: hidden by hand, by a filter, in a closed group, or of zero height.
    pub(crate) hidden_rows: BTreeSet<u32>,
    /// Hidden columns, from 0.
    pub(crate) hidden_columns: BTreeSet<u32>,
    /// Formulas without a result, by row and column.
    pub(crate) uncalculated: BTreeSet<(u32, u32)>,
}

impl Shown {
    pub(crate) fn is_hidden(&self, row: u32, column: u32) -> bool {
        self.hidden_rows.contains(&row) || self.hidden_columns.contains(&column)
    }

    /// Hides the columns of a range.
    pub(crate) fn hide_columns(&mut self, first: u32, last: u32) {
        self.hidden_columns.extend(first..=last.min(limits::COLUMNS));
    }

    /// Notes on hidden contents of a sheet. `seen` are the cells that are not empty.
    pub(crate) fn notes(&self, sheet: &str, seen: &BTreeSet<(u32, u32)>) -> Vec<String> {
        let rows = self
            .hidden_rows
            .iter()
            .filter(|row| seen.range((**row, 0)..=(**row, u32::MAX)).next().is_some());
        let rows: Vec<u32> = rows.map(|row| row + 1).collect();
        let columns: BTreeSet<u32> = seen.iter().map(|(_, column)| *column).collect();
        let columns = self.hidden_columns.iter().filter(|column| columns.contains(column));
        let columns: Vec<u32> = columns.map(|column| column + 1).collect();
        let mut notes = Vec::new();
        let number = |row: u32| row.to_string();
        for (noun, places, show) in [
            ("row", rows, &number as &dyn Fn(u32) -> String),
            ("column", columns, &crate::error::letters),
        ] {
            if places.is_empty() {
                continue;
            }
            let (noun, verb) = match places.len() {
                1 => (noun.to_owned(), "is"),
                _ => (format!("{noun}s"), "are"),
            };
            let listed = listed(&places, show);
            notes.push(format!("{noun} {listed} of sheet '{sheet}' {verb} hidden and not read"));
        }
        notes
    }
}

/// Lists numbers, consecutive ones as `3 to 5`.
fn listed(numbers: &[u32], show: &dyn Fn(u32) -> String) -> String {
    const LISTED: usize = 10;
    let runs: Vec<&[u32]> = numbers.chunk_by(|one, next| next - one == 1).collect();
    let mut texts: Vec<String> = runs
        .iter()
        .take(LISTED)
        .map(|run| match run {
            [one] => show(*one),
            [first, .., last] => format!("{} to {}", show(*first), show(*last)),
            [] => String::new(),
        })
        .collect();
    if runs.len() > LISTED {
        texts.push("others".to_owned());
    }
    match texts.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => texts.concat(),
    }
}

/// Visibility of the contents of some sheets of an `.xlsx`, which are given by their indices among
/// all.
pub(crate) fn of_sheets(parts: &Parts, places: &[usize]) -> Result<Vec<Shown>, TableErrorKind> {
    let workbook = workbook_part(parts);
    let (folder, file) = workbook.rsplit_once('/').unwrap_or(("", &workbook));
    let folder = if folder.is_empty() { String::new() } else { format!("{folder}/") };
    let relations = relations(parts, &format!("{folder}_rels/{file}.rels"));
    let Some(content) = parts.get(&workbook) else { return Err(missing("its workbook")) };
    let mut ids: Vec<String> = Vec::new();
    let mut is_calculated_on_load = false;
    each(content, |start| match start.local_name().as_ref() {
        "sheet" => ids.push(attribute(start, "id")),
        "calcPr" => is_calculated_on_load |= is_true(&attribute(start, "fullCalcOnLoad")),
        _ => {}
    });
    let sheet = |place: usize| {
        let id = ids.get(place)?;
        let (_, target) = relations.iter().find(|(relation, _)| relation == id)?;
        let path = match target.strip_prefix('/') {
            Some(path) => path.to_owned(),
            None => format!("{folder}{target}"),
        };
        parts.get(&path.to_ascii_lowercase().replace('\\', "/"))
    };
    let visible = |&place: &usize| {
        let content = sheet(place).ok_or_else(|| missing("the part of a sheet"))?;
        Ok(of_sheet(content, is_calculated_on_load))
    };
    places.iter().map(visible).collect()
}

fn missing(what: &str) -> TableErrorKind {
    TableErrorKind::NotAWorkbook { reason: format!("{what} is missing") }
}

/// Name of the workbook's part.
fn workbook_part(parts: &Parts) -> String {
    let mut found = None;
    if let Some(content) = parts.get("_rels/.rels") {
        each(content, |start| {
            if attribute(start, "Type").ends_with("/relationships/officeDocument") {
                found.get_or_insert(attribute(start, "Target"));
            }
        });
    }
    let found = found.unwrap_or_else(|| "xl/workbook.xml".to_owned());
    found.trim_start_matches('/').to_ascii_lowercase()
}

/// The identifiers and targets of a part of relationships.
fn relations(parts: &Parts, name: &str) -> Vec<(String, String)> {
    let mut relations = Vec::new();
    if let Some(content) = parts.get(&name.to_ascii_lowercase()) {
        each(content, |start| {
            if start.local_name().as_ref() == "Relationship" {
                relations.push((attribute(start, "Id"), attribute(start, "Target")));
            }
        });
    }
    relations
}

/// Calls a function for each start tag. Malformed XML ends the iteration; the reader of workbooks
/// reports it.
fn each(content: &[u8], mut visit: impl FnMut(&BytesStart)) {
    let mut reader = reader(content);
    let mut buffer = Vec::new();
    loop {
        buffer.clear();
        match reader.read_event_into(&mut buffer) {
            Ok(Event::Start(start)) => visit(&start),
            Ok(Event::Eof) | Err(_) => return,
            Ok(_) => {}
        }
    }
}

/// An XML reader with the settings of the reader of workbooks.
fn reader(content: &[u8]) -> Reader<&[u8]> {
    let mut reader = Reader::from_reader(content);
    let config = reader.config_mut();
    config.check_end_names = false;
    config.check_comments = false;
    config.expand_empty_elements = true;
    reader
}

/// An attribute by its local name; empty if it is missing.
fn attribute(start: &BytesStart, name: &str) -> String {
    let found = start
        .attributes()
        .filter_map(Result::ok)
        .find(|attribute| attribute.key.local_name().as_ref() == name);
    let value = found.map(|attribute| {
        let unescaped =
            quick_xml::escape::unescape(&attribute.value).map(|value| value.into_owned());
        unescaped.unwrap_or_else(|_| attribute.value.to_string())
    });
    value.unwrap_or_default()
}

fn is_true(value: &str) -> bool {
    value == "1" || value.eq_ignore_ascii_case("true")
}

fn is_zero(value: &str) -> bool {
    value.trim().parse::<f64>().is_ok_and(|value| value == 0.0)
}

/// A cell that is partly read.
#[derive(Default)]
struct Open {
    at: (u32, u32),
    kind: String,
    has_formula: bool,
    has_value: bool,
    is_inline: bool,
    value: String,
}

/// Visibility of the contents of a sheet.
fn of_sheet(content: &[u8], is_calculated_on_load: bool) -> Shown {
    let mut visible = Shown::default();
    let mut arrays: Vec<[(u32, u32); 2]> = Vec::new();
    let mut reader = reader(content);
    let mut buffer = Vec::new();
    let (mut row, mut column) = (0_u32, 0_u32);
    let mut cell: Option<Open> = None;
    let mut in_value = false;
    loop {
        buffer.clear();
        match reader.read_event_into(&mut buffer) {
            Ok(Event::Start(start)) => match start.local_name().as_ref() {
                "col" => {
                    let number = |name: &str| attribute(&start, name).parse::<u32>().unwrap_or(0);
                    let (first, last) = (number("min"), number("max"));
                    let width = attribute(&start, "width");
                    if first > 0 && (is_true(&attribute(&start, "hidden")) || is_zero(&width)) {
                        visible.hide_columns(first - 1, last.saturating_sub(1));
                    }
                }
                "row" => {
                    if let Ok(number) = attribute(&start, "r").parse::<u32>() {
                        row = number.saturating_sub(1);
                    }
                    let is_flat = is_zero(&attribute(&start, "ht"));
                    let is_hidden = is_true(&attribute(&start, "hidden")) || is_flat;
                    if is_hidden && (row as usize) < limits::ROWS {
                        visible.hidden_rows.insert(row);
                    }
                }
                "c" => {
                    if let Some(at) = position(&attribute(&start, "r")) {
                        column = at.1;
                        cell = Some(Open { at, ..Open::default() });
                    } else {
                        cell = Some(Open { at: (row, column), ..Open::default() });
                    }
                    if let Some(cell) = &mut cell {
                        cell.kind = attribute(&start, "t");
                    }
                }
                "f" => {
                    if let Some(cell) = &mut cell {
                        cell.has_formula = true;
                        if attribute(&start, "t") == "array" && arrays.len() < ARRAYS {
                            arrays.extend(range(&attribute(&start, "ref")));
                        }
                    }
                }
                "v" => {
                    in_value = true;
                    if let Some(cell) = &mut cell {
                        cell.has_value = true;
                    }
                }
                "is" => {
                    if let Some(cell) = &mut cell {
                        cell.is_inline = true;
                    }
                }
                _ => {}
            },
            Ok(Event::Text(text)) if in_value => {
                if let Some(cell) = cell.as_mut().filter(|cell| cell.value.len() < 64) {
                    cell.value.push_str(text.as_ref());
                }
            }
            Ok(Event::End(end)) => match end.local_name().as_ref() {
                "v" => in_value = false,
                "row" => (row, column) = (row.saturating_add(1), 0),
                "c" => {
                    column = column.saturating_add(1);
                    if let Some(cell) = cell.take()
                        && is_uncalculated(&cell, &arrays, is_calculated_on_load)
                    {
                        visible.uncalculated.insert(cell.at);
                    }
                }
                "sheetData" => return visible,
                _ => {}
            },
            Ok(Event::Eof) | Err(_) => return visible,
            Ok(_) => {}
        }
    }
}

/// Whether a cell contains a formula without its result.
fn is_uncalculated(cell: &Open, arrays: &[[(u32, u32); 2]], is_calculated_on_load: bool) -> bool {
    let is_in = |[from, to]: &[(u32, u32); 2]| {
        (from.0..=to.0).contains(&cell.at.0) && (from.1..=to.1).contains(&cell.at.1)
    };
    let is_number = cell.kind.is_empty() || cell.kind == "n";
    let is_placeholder = is_calculated_on_load && is_number && is_zero(&cell.value);
    if !cell.has_formula {
        return is_placeholder && arrays.iter().any(is_in);
    }
    // The result of `=IF(A2="","",A2)` is an empty text.
    let is_empty_text = cell.kind == "str" && cell.has_value;
    let is_empty = cell.value.trim().is_empty() && !is_empty_text && !cell.is_inline;
    is_empty || is_placeholder
}

/// Row and column of `C2`, from 0.
fn position(text: &str) -> Option<(u32, u32)> {
    let digits = text.find(|c: char| c.is_ascii_digit())?;
    let (letters, row) = text.split_at(digits);
    let column = letters.trim_matches('$').bytes().try_fold(0_u32, |sum, byte| {
        let letter = byte.to_ascii_uppercase().checked_sub(b'A').filter(|letter| *letter < 26)?;
        sum.checked_mul(26)?.checked_add(u32::from(letter) + 1)
    })?;
    Some((row.parse::<u32>().ok()?.checked_sub(1)?, column.checked_sub(1)?))
}

/// The corners of `C2:C9`.
fn range(text: &str) -> Option<[(u32, u32); 2]> {
    let (from, to) = text.split_once(':').unwrap_or((text, text));
    Some([position(from)?, position(to)?])
}
