//! Rows of a log in text.

use std::collections::VecDeque;

use wholestring_tabular::is_comment;
use wholestring_units::Dimension;

use super::{
    super::{
        lines::{LONGEST_LINE, Lines, text},
        log::{Opened, short},
        number::Marks,
        record::{Row, Rows},
    },
    head::{self, Found},
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Maximum number of lines of a remark in quotation marks.
const QUOTED_LINES: usize = 100;

struct CsvRows<'a> {
    lines: Lines<'a>,
    /// Lines that were read to find the headings, and the number of the next.
    ahead: VecDeque<Vec<u8>>,
    line: u64,
    sign: u8,
    columns: usize,
    /// Cells of the headings and of the units below them, and the lines where they are repeated.
    headings: Vec<Vec<Vec<u8>>>,
    /// Whether a heading begins with a digit, as `0108` does.
    has_items: bool,
    repeated: (u64, u64),
}

/// Opens the log below its headings.
pub(super) fn open<'a>(
    lines: Lines<'a>,
    ahead: Vec<Vec<u8>>,
    found: Found,
) -> Result<Opened<'a>, ImportError> {
    let Found { sign, headings, data, columns, passed_over, .. } = found;
    let name = match sign {
        b',' => "commas",
        b';' => "semicolons",
        b'\t' => "tabs",
        _ => "bars",
    };
    let mut notes = Vec::new();
    if headings > 0 {
        notes.push(Note::Read(format!("the headings are in line {}", headings + 1)));
    }
    for at in passed_over {
        let line = short(text(&ahead[at]).trim().as_bytes());
        notes.push(Note::LeftOut(format!("line {}, which is not a row: '{line}'", at + 1)));
    }
    let columns_of_head = columns.len();
    let above = headings..data.min(ahead.len());
    let headings = ahead[above].iter().map(|line| cells(&head::parted(line, sign)));
    let headings = headings.filter(|cells| cells.iter().any(|cell| !cell.is_empty()));
    let headings: Vec<Vec<Vec<u8>>> = headings.collect();
    let begins = |cell: &Vec<u8>| cell.first().is_some_and(u8::is_ascii_digit);
    let has_items = headings.iter().flatten().any(begins);
    let rows = CsvRows {
        ahead: ahead.into_iter().skip(data).collect(),
        line: data as u64,
        sign,
        columns: columns_of_head,
        headings,
        has_items,
        repeated: (0, 0),
        lines,
    };
    Ok(Opened {
        file: rows.lines.file().to_owned(),
        what: format!("a log of a rig as text, separated by {name}"),
        well: None,
        columns,
        null: None,
        marks: if sign == b',' { Marks::Point } else { Marks::Comma },
        start: None,
        notes,
        rows: Box::new(rows),
    })
}

/// Cells of a row without empty ones at its end.
fn cells(row: &Row) -> Vec<Vec<u8>> {
    let mut cells: Vec<Vec<u8>> =
        (0..row.cells.len()).map(|at| row.cell(at).to_ascii_lowercase()).collect();
    while cells.last().is_some_and(Vec::is_empty) {
        cells.pop();
    }
    cells
}

/// Whether all cells of a row are units, or empty.
fn is_units(row: &Row) -> bool {
    let cells = cells(row);
    let mut filled = cells.iter().filter(|cell| !cell.is_empty()).peekable();
    let is_unit = |cell: &Vec<u8>| {
        let cell = text(cell);
        let bare = cell.trim().trim_matches(['(', ')', '[', ']']).trim();
        Dimension::ALL.iter().any(|dimension| dimension.find_unit(bare).is_some())
    };
    filled.peek().is_some() && filled.all(is_unit)
}

impl CsvRows<'_> {
    /// Whether a row repeats the headings, or the units below them, as in a log joined from
    /// several.
    ///
    /// # Errors
    /// It has different headings.
    fn is_heading(&mut self, row: &Row) -> Result<bool, ImportError> {
        // Rows of data contain numbers or dates; of rows of headings only those of WITS items do.
        let is_number = |&(from, to): &(u32, u32)| {
            let byte = row.bytes[from as usize..to as usize].first();
            byte.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'+' | b'.'))
        };
        if !self.has_items && row.cells.iter().any(is_number) {
            return Ok(false);
        }
        if self.headings.contains(&cells(row)) {
            if self.repeated.0 == 0 {
                self.repeated.1 = row.line;
            }
            self.repeated.0 += 1;
            return Ok(true);
        }
        if is_units(row) {
            let sentence = "units follow that are not those of the headings; cut the file there \
                            and read its parts one by one";
            let place = Some(format!("line {}", row.line));
            let kind = ImportErrorKind::Refused(sentence.to_owned());
            return Err(ImportError::new(self.lines.file(), place, kind));
        }
        if head::is_heading(row) {
            let sentence = "the headings of another log follow, in another order or of other \
                            channels; cut the file there and read its parts one by one";
            let place = Some(format!("line {}", row.line));
            let kind = ImportErrorKind::Refused(sentence.to_owned());
            return Err(ImportError::new(self.lines.file(), place, kind));
        }
        Ok(false)
    }

    /// Adds notes on the skipped lines.
    fn finish(&self, notes: &mut Vec<Note>) {
        let (count, line) = self.repeated;
        if count > 0 {
            let lines = if count == 1 { "1 line".to_owned() } else { format!("{count} lines") };
            notes.push(Note::LeftOut(format!(
                "{lines} with the headings again, the first line {line}"
            )));
        }
    }

    fn line(&mut self, into: &mut Vec<u8>) -> Result<bool, ImportError> {
        self.line += 1;
        match self.ahead.pop_front() {
            Some(line) => {
                into.extend_from_slice(&line);
                Ok(true)
            }
            None => self.lines.next(into),
        }
    }
}

impl Rows for CsvRows<'_> {
    fn next(&mut self, row: &mut Row, notes: &mut Vec<Note>) -> Result<bool, ImportError> {
        loop {
            row.clear();
            if !self.line(&mut row.bytes)? {
                self.finish(notes);
                return Ok(false);
            }
            row.line = self.line;
            // Remarks in quotation marks may contain line ends.
            let mut lines = 1;
            while !row.part_at(self.sign, 0) {
                row.bytes.push(b'\n');
                row.cells.clear();
                lines += 1;
                let too_long = lines > QUOTED_LINES || row.bytes.len() > 2 * LONGEST_LINE;
                if too_long || !self.line(&mut row.bytes)? {
                    let sentence = format!(
                        "a quotation mark opens and is not closed within {QUOTED_LINES} lines"
                    );
                    let place = Some(format!("line {}", row.line));
                    let kind = ImportErrorKind::Refused(sentence);
                    return Err(ImportError::new(self.lines.file(), place, kind));
                }
            }
            let filled = row.cells.iter().filter(|(from, to)| to > from).count();
            let is_comment = row.bytes.first() == Some(&b'#')
                && is_comment(text(row.cell(0)).trim(), filled > 1);
            if filled == 0 || is_comment || self.is_heading(row)? {
                continue;
            }
            break;
        }
        while row.cells.len() > self.columns && row.cell(row.cells.len() - 1).is_empty() {
            row.cells.pop();
        }
        if row.cells.len() > self.columns {
            let (found, expected) = (row.cells.len(), self.columns);
            let mut sentence = format!("the row has {found} cells; {expected} were expected");
            if self.sign == b',' {
                sentence.push_str(" (are there commas within numbers?)");
            }
            let place = Some(format!("line {}", row.line));
            let kind = ImportErrorKind::Refused(sentence);
            return Err(ImportError::new(self.lines.file(), place, kind));
        }
        // A file that was copied while it grew may end within a row.
        let is_last = self.ahead.is_empty() && self.lines.cut();
        if is_last && row.cells.len() < self.columns {
            notes.push(Note::LeftOut(format!(
                "the last row, line {}: the file ends within it",
                row.line
            )));
            self.finish(notes);
            return Ok(false);
        }
        Ok(true)
    }
}
