//! The file of a bit's table: CSV, a line of column names and a line for each point.

use std::{f64::consts::PI, ops::Range as ByteRange};

use wholestring::dynamics::TablePoint;
use wholestring_config::prelude::*;

use crate::beside::read_beside;

/// Maximum number of lines in the file of a bit's table.
pub(super) const MAX: usize = 10_000;

/// Columns of the file: name, value of one unit in SI, whether the column is required.
const COLUMNS: [(&str, f64, bool); 6] = [
    ("weight_on_bit_N", 1.0, true),
    ("rotary_speed_rpm", PI / 30.0, true),
    ("rate_of_penetration_m_per_h", 1.0 / 3600.0, true),
    ("torque_N_m", 1.0, true),
    ("torque_std_N_m", 1.0, false),
    ("weight_on_bit_std_N", 1.0, false),
];

/// The content of a cell, with its place in the text.
#[derive(Debug, Clone)]
struct Cell<'a> {
    text: &'a str,
    span: ByteRange<usize>,
}

/// Reads the points of a file that the case names.
pub(super) fn read(
    file: &Spanned<String>,
    files: &dyn Files,
    reader: &mut Reader,
) -> Option<Vec<Spanned<TablePoint>>> {
    let name = short(&file.value);
    let bytes = read_beside(file, "table", files, reader)?;
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let Ok(text) = std::str::from_utf8(bytes) else {
        return Diagnostic::error(format!("the table `{name}` is not a text"))
            .at(file.place, "expected a CSV file in UTF-8")
            .refuse(reader);
    };
    let lines = lines(text);
    let Some((head, lines)) = lines.split_first().filter(|(_, lines)| lines.len() <= MAX) else {
        let (what, expected) = match lines.len() {
            0 => ("is empty".to_owned(), "expected a line of column names"),
            more => (format!("has {} points", more - 1), "expected at most 10000"),
        };
        return Diagnostic::error(format!("the table `{name}` {what}"))
            .at(file.place, expected)
            .refuse(reader);
    };
    let source = reader.add_source(&file.value, text);
    let found = columns(head, source).and_then(|found| {
        let points = lines.iter().map(|line| point(line, &found, source));
        points.collect::<Result<Vec<_>, _>>()
    });
    match found {
        Ok(points) => Some(points),
        Err(diagnostic) => {
            reader.report(diagnostic.at(file.place, "the table"));
            None
        }
    }
}

/// Returns the lines that are not blank.
fn lines(text: &str) -> Vec<Cell<'_>> {
    let mut from = 0;
    let lines = text.split_inclusive('\n').map(|line| {
        from += line.len();
        trimmed(line, from - line.len())
    });
    lines.filter(|line| !line.text.is_empty()).collect()
}

fn cells<'a>(line: &Cell<'a>) -> Vec<Cell<'a>> {
    let mut from = line.span.start;
    let cells = line.text.split(',').map(|cell| {
        from += cell.len() + 1;
        trimmed(cell, from - cell.len() - 1)
    });
    cells.collect()
}

/// Returns a text that begins at `from` without the blanks around it.
fn trimmed(text: &str, from: usize) -> Cell<'_> {
    let begin = from + (text.len() - text.trim_start().len());
    let text = text.trim();
    Cell { text, span: begin..begin + text.len() }
}

fn place(source: usize, span: &ByteRange<usize>) -> Span {
    Span { source, start: span.start, end: span.end }
}

/// Position of each column; `None` for an optional column that is missing.
fn columns(head: &Cell<'_>, source: usize) -> Result<[Option<usize>; 6], Diagnostic> {
    let names = cells(head);
    let mut found = [None; 6];
    for ((column, _, required), at) in COLUMNS.iter().zip(&mut found) {
        *at = names.iter().position(|cell| cell.text == *column);
        if at.is_some() {
            continue;
        }
        if *required {
            return Err(Diagnostic::error(format!("the table has no column `{column}`"))
                .at(place(source, &head.span), format!("`{column}` is missing")));
        }
        // A column with nearly the right name was meant to be it.
        let near = names.iter().find(|cell| {
            let known = COLUMNS.iter().any(|(name, ..)| *name == cell.text);
            !known && nearest(cell.text, [*column]).is_some()
        });
        if let Some(cell) = near {
            return Err(Diagnostic::error(format!("unknown column `{}`", short(cell.text)))
                .at(place(source, &cell.span), "unknown column")
                .help(format!("did you mean `{column}`?")));
        }
    }
    Ok(found)
}

fn point(
    line: &Cell<'_>,
    found: &[Option<usize>; 6],
    source: usize,
) -> Result<Spanned<TablePoint>, Diagnostic> {
    let cells = cells(line);
    let number = |column: usize| -> Result<Option<f64>, Diagnostic> {
        let (name, worth, _) = COLUMNS[column];
        let Some(at) = found[column] else {
            return Ok(None);
        };
        let Some(cell) = cells.get(at) else {
            return Err(Diagnostic::error("this line is too short")
                .at(place(source, &line.span), format!("`{name}` is missing")));
        };
        match cell.text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Some(number * worth)),
            _ => Err(Diagnostic::error(format!("`{}` is not a number", short(cell.text)))
                .at(place(source, &cell.span), format!("expected a number of `{name}`"))),
        }
    };
    // Required columns have been found by now.
    let needed = |column: usize| number(column).map(Option::unwrap_or_default);
    Ok(Spanned {
        value: TablePoint {
            weight_on_bit_N: needed(0)?,
            rotary_speed_rad_per_s: needed(1)?,
            rate_of_penetration_m_per_s: needed(2)?,
            torque_N_m: needed(3)?,
            torque_std_N_m: number(4)?,
            weight_on_bit_std_N: number(5)?,
        },
        place: place(source, &line.span),
    })
}
