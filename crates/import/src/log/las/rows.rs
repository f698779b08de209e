//! The rows of a LAS file.

use super::{
    super::{
        lines::{LONGEST_LINE, Lines},
        log::{Opened, short},
        moment::{Order, date, moment, time_of_day},
        number::Marks,
        record::{Row, Rows},
    },
    head::{Head, Parted},
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Rows of a LAS file with their separator.
struct LasRows<'a> {
    lines: Lines<'a>,
    /// The first line of data, from which the separator was determined.
    first: Option<Vec<u8>>,
    parted: Parted,
    wrapped: bool,
    columns: usize,
    /// Names of the curves in lower case, which joined files repeat.
    names: Vec<Vec<u8>>,
    /// Number of lines with the names, of which the first is noted.
    repeated: usize,
    /// Whether the first line of a wrapped row contains only the index, as in the standard.
    alone: Option<bool>,
    /// A date column whose time follows after a blank.
    joined: Option<usize>,
    ended: bool,
}

/// Examines the first line of data.
pub(super) fn open<'a>(mut lines: Lines<'a>, head: Head) -> Result<Opened<'a>, ImportError> {
    let Head { version, wrapped, parted, null, well, start, columns, mut notes, .. } = head;
    let mut first = Vec::new();
    let ended = !data_line(&mut lines, &mut first, &mut notes)?;
    let mut rows = LasRows {
        lines,
        first: None,
        parted: parted.unwrap_or(Parted::Blanks),
        wrapped,
        columns: columns.len(),
        names: columns.iter().map(|column| column.mnemonic.to_lowercase().into_bytes()).collect(),
        repeated: 0,
        alone: None,
        joined: None,
        ended,
    };
    if !ended && !wrapped {
        let line = Row { bytes: first.clone(), ..Row::default() };
        rows.look(line, parted, &mut notes);
    }
    rows.first = (!ended).then_some(first);
    let version = if version.is_empty() { "without a version".to_owned() } else { version };
    let wrap = if wrapped { ", wrapped" } else { "" };
    Ok(Opened {
        file: rows.lines.file().to_owned(),
        what: format!("LAS {version}{wrap}"),
        well,
        columns,
        null,
        marks: if rows.parted == Parted::By(b',') { Marks::Point } else { Marks::Either },
        start,
        notes,
        rows: Box::new(rows),
    })
}

/// Appends the next line of data; false where the section ends.
fn data_line(
    lines: &mut Lines,
    into: &mut Vec<u8>,
    notes: &mut Vec<Note>,
) -> Result<bool, ImportError> {
    let from = into.len();
    loop {
        into.truncate(from);
        if !lines.next(into)? {
            into.truncate(from);
            return Ok(false);
        }
        let line = into[from..].trim_ascii();
        match line.first() {
            // Some files end with an old end-of-file character.
            None | Some(b'#' | 0x1a | 0) => {}
            Some(b'~') if is_data_section(line) => {
                let text = format!(
                    "the {} of line {} continues the rows above",
                    short(line),
                    lines.line()
                );
                notes.push(Note::Read(text));
            }
            Some(b'~') => {
                let text = format!("what follows from line {}: {}", lines.line(), short(line));
                notes.push(Note::LeftOut(text));
                refuse_more_data(lines)?;
                return Ok(false);
            }
            Some(_) => return Ok(true),
        }
    }
}

/// Whether a line begins a section of rows, `~A` of LAS 1.2 and 2.0.
fn is_data_section(line: &[u8]) -> bool {
    matches!(line, [b'~', b'A' | b'a', ..])
}

/// Refuses rows behind another section: they are of another head, as in joined files.
fn refuse_more_data(lines: &mut Lines) -> Result<(), ImportError> {
    let mut line = Vec::new();
    while lines.next(&mut line)? {
        if is_data_section(line.trim_ascii()) {
            let sentence = format!(
                "another section of rows, {}, after other sections: expected one log; cut the \
                 file above its second head and import the parts one by one",
                short(line.trim_ascii())
            );
            return Err(lines.error(ImportErrorKind::Refused(sentence)));
        }
        line.clear();
    }
    Ok(())
}

impl LasRows<'_> {
    /// Determines the separator of cells from the first row, if the head does not give it or is
    /// wrong.
    fn look(&mut self, mut line: Row, declared: Option<Parted>, notes: &mut Vec<Note>) {
        match self.parted {
            Parted::Blanks => line.part_at_blanks(0),
            Parted::By(sign) => {
                line.part_at(sign, 0);
            }
        }
        let count = line.cells.len();
        // "0, 1, 2" has three words, but not three numbers.
        let commas =
            self.parted == Parted::Blanks && (0..count).any(|at| line.cell(at).ends_with(b","));
        if count == self.columns && !commas {
            return;
        }
        // "2021-03-24 12:34:56" is one value.
        if self.parted == Parted::Blanks && count == self.columns + 1 && !commas {
            let is_pair = |&at: &usize| {
                date(line.cell(at), Order::DayFirst).is_some()
                    && line.cell(at).len() >= 6
                    && line.cell(at + 1).contains(&b':')
                    && time_of_day(line.cell(at + 1)).is_some()
            };
            self.joined = (0..self.columns).find(is_pair);
            if self.joined.is_some() {
                return;
            }
        }
        let mut cells = |sign: u8| {
            line.cells.clear();
            line.part_at(sign, 0);
            if line.cells.last().is_some_and(|(from, to)| from == to) {
                line.cells.pop();
            }
            line.cells.len()
        };
        if let Some((sign, name)) = [(b',', "commas"), (b'\t', "tabs"), (b';', "semicolons")]
            .into_iter()
            .find(|(sign, _)| cells(*sign) == self.columns)
        {
            self.parted = Parted::By(sign);
            let but = if declared.is_some() { "; the head declares another separator" } else { "" };
            notes.push(Note::Read(format!("{name} separate the cells of the rows{but}")));
        }
    }

    fn part(&self, row: &mut Row, from: usize) {
        match self.parted {
            Parted::Blanks => row.part_at_blanks(from),
            Parted::By(sign) => {
                row.part_at(sign, from);
            }
        }
        if let Some(at) = self.joined
            && row.cells.len() == self.columns + 1
        {
            let (_, end) = row.cells.remove(at + 1);
            row.cells[at].1 = end;
        }
    }

    /// Whether a row has the names of the curves, as in a file joined from several.
    fn is_heading(&self, row: &Row) -> bool {
        !self.wrapped
            && row.cells.len() == self.columns
            && self
                .names
                .iter()
                .enumerate()
                .all(|(at, name)| row.cell(at).eq_ignore_ascii_case(name))
    }

    /// The error of a row whose number of cells differs from that of the curves.
    fn uneven(&self, row: &Row) -> ImportError {
        let (found, expected) = (row.cells.len(), self.columns);
        let run_on = (0..found).map(|at| row.cell(at)).find(|cell| has_run_on(cell));
        let why = match run_on {
            Some(cell) => format!("; '{}' may be two numbers that have run together", short(cell)),
            None if self.wrapped => "; a wrapped row ends with its last line".to_owned(),
            None => String::new(),
        };
        let sentence = format!("the row has {found} values; {expected} were expected{why}");
        let place = Some(format!("line {}", row.line));
        ImportError::new(self.lines.file(), place, ImportErrorKind::Refused(sentence))
    }
}

impl Rows for LasRows<'_> {
    fn next(&mut self, row: &mut Row, notes: &mut Vec<Note>) -> Result<bool, ImportError> {
        row.clear();
        if self.ended {
            return Ok(false);
        }
        if let Some(first) = self.first.take() {
            row.bytes = first;
        } else if !data_line(&mut self.lines, &mut row.bytes, notes)? {
            self.ended = true;
            return Ok(false);
        }
        row.line = self.lines.line();
        self.part(row, 0);
        while self.is_heading(row) {
            self.repeated += 1;
            if self.repeated == 1 {
                notes.push(Note::LeftOut(format!(
                    "lines with the names of the curves again, the first line {}",
                    row.line
                )));
            }
            row.clear();
            if !data_line(&mut self.lines, &mut row.bytes, notes)? {
                self.ended = true;
                return Ok(false);
            }
            row.line = self.lines.line();
            self.part(row, 0);
        }
        let alone = row.cells.len() == 1;
        if self.wrapped && alone != *self.alone.get_or_insert(alone) {
            let sentence =
                "this wrapped row begins differently from the first, with or without its index \
                 alone in a line; a value may be missing above"
                    .to_owned();
            return Err(self.lines.error(ImportErrorKind::Refused(sentence)));
        }
        while self.wrapped && row.cells.len() < self.columns {
            row.bytes.push(b' ');
            let from = row.bytes.len();
            if !data_line(&mut self.lines, &mut row.bytes, notes)? {
                self.ended = true;
                notes.push(cut(row));
                return Ok(false);
            }
            self.part(row, from);
            if row.bytes.len() > 2 * LONGEST_LINE {
                let most = format!("{} MB", (2 * LONGEST_LINE) >> 20);
                let found = format!("a wrapped row of more than {most}");
                return Err(self.lines.error(ImportErrorKind::TooMuch { found, most }));
            }
        }
        if row.cells.len() == self.columns {
            return Ok(true);
        }
        // A comma after the last value separates nothing.
        if row.cells.len() == self.columns + 1 && row.cell(self.columns).is_empty() {
            row.cells.pop();
            return Ok(true);
        }
        if self.lines.cut() && row.cells.len() < self.columns {
            self.ended = true;
            notes.push(cut(row));
            return Ok(false);
        }
        Err(self.uneven(row))
    }
}

/// Note on a last row that is incomplete because the file was copied while it grew.
fn cut(row: &Row) -> Note {
    Note::LeftOut(format!("the last row, line {}: the file ends within it", row.line))
}

/// Whether a cell has two points, or a sign after digits: `7.020101130.188`, `7.330-19508.961`.
fn has_run_on(cell: &[u8]) -> bool {
    let numeric = |b: &u8| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+');
    let points = cell.iter().filter(|b| **b == b'.').count();
    let sign = cell.windows(2).any(|pair| pair[0].is_ascii_digit() && pair[1] == b'-');
    cell.iter().all(numeric)
        && (points > 1 || sign && points > 0)
        && moment(cell, Order::DayFirst).is_none()
}
