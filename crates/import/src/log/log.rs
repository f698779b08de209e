//! A log, row by row.

use wholestring_tabular::is_null;
use wholestring_units::Unit;

use super::{
    channel::{Channel, Column, Wanted, choose},
    clock::Clock,
    number::{self, Marks, is_nothing, marked},
    quantity::Quantity,
    record::{Record, Row, Rows},
    watch::Watch,
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Number of rows read in advance to determine the format of numbers and times.
const AHEAD: usize = 64;

/// Maximum bytes of the rows of a log that is sorted by time, because all of them are read first.
const SORTED_BYTES: usize = 256 << 20;

/// A log whose head has been read.
pub(crate) struct Opened<'a> {
    pub(crate) file: String,
    /// Format and version: `LAS 2.0`.
    pub(crate) what: String,
    pub(crate) well: Option<String>,
    pub(crate) columns: Vec<Column>,
    pub(crate) null: Option<f64>,
    pub(crate) marks: Marks,
    /// Start of a log whose times are relative to it.
    pub(crate) start: Option<String>,
    pub(crate) notes: Vec<Note>,
    pub(crate) rows: Box<dyn Rows + 'a>,
}

/// A log whose channels are known and whose rows are read on demand.
///
/// It ends after its first error.
pub struct Log<'a> {
    /// Format and version: `LAS 2.0`.
    pub what: String,
    /// Name of the well, if given in the file.
    pub well: Option<String>,
    /// Its channels, in order.
    pub channels: Vec<Channel>,
    /// Notes on its interpretation; those on the rows follow after the last row.
    pub notes: Vec<Note>,
    /// Date and time of the first row, if given in the file.
    pub start: Option<String>,
    /// Choices that the user must make before rows can be read.
    pub(crate) asked: Vec<ImportErrorKind>,
    file: String,
    rows: Box<dyn Rows + 'a>,
    /// Rows that were read in advance, the next one last, and whether more follow.
    ahead: Vec<Row>,
    more: bool,
    row: Row,
    wanted: Vec<(Wanted, Vec<f64>)>,
    clock: Option<Clock>,
    marks: Marks,
    watch: Watch,
    ended: bool,
}

impl std::fmt::Debug for Log<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Log").field("what", &self.what).field("channels", &self.channels).finish()
    }
}

impl<'a> Log<'a> {
    /// Chooses the channels and examines the first rows.
    pub(crate) fn of(opened: Opened<'a>, choices: &Choices) -> Result<Self, ImportError> {
        let Opened { file, what, well, columns, null, mut marks, start, mut notes, mut rows } =
            opened;
        let mut chosen = choose(&columns, choices);
        let mut ahead = Vec::new();
        let mut more = true;
        while more && ahead.len() < AHEAD {
            let mut row = Row::default();
            more = rows.next(&mut row, &mut notes)?;
            if more {
                ahead.push(row);
            }
        }
        if marks == Marks::Comma {
            marks = number::marks(ahead.iter().flat_map(|row| {
                chosen
                    .wanted
                    .iter()
                    .map(|wanted| row.cell(wanted.column))
                    .filter(|cell| !cell.is_empty())
            }));
            if marks == Marks::Comma {
                notes.push(Note::Read("numbers have decimal commas".to_owned()));
            }
        }
        let clock = match Clock::of(&mut chosen, &ahead, marks, choices) {
            Ok(clock) => clock,
            Err(kind) => {
                chosen.asked.push(kind);
                None
            }
        };
        let mut zeros = Vec::new();
        let mut nulls = |wanted: &Wanted| {
            let all = null.into_iter().chain(columns[wanted.column].null);
            let (zero, others): (Vec<f64>, Vec<f64>) = all.partition(|null| *null == 0.0);
            if zero.is_empty() || !wanted.quantity.is_often_zero() {
                return [zero, others].concat();
            }
            zeros.push(wanted.quantity.words());
            others
        };
        let wanted: Vec<(Wanted, Vec<f64>)> = chosen
            .wanted
            .into_iter()
            .map(|wanted| {
                let nulls = nulls(&wanted);
                (wanted, nulls)
            })
            .collect();
        if !zeros.is_empty() {
            notes.push(Note::Assumed(format!(
                "0 is read as a value of {}, although the head declares it as the null value, \
                 because these are often 0",
                zeros.join(", ")
            )));
        }
        notes.extend(chosen.notes);
        if clock.as_ref().is_some_and(|clock| is_newest_first(clock, &ahead)) {
            more &= read_all(&mut *rows, &mut ahead, &mut notes, &file)?;
            notes.push(Note::Read(
                "the log runs newest first: its rows are read from the last one to the first"
                    .to_owned(),
            ));
        } else {
            ahead.reverse();
        }
        let mut log = Self {
            what,
            well,
            channels: chosen.channels,
            notes,
            start,
            asked: chosen.asked,
            file,
            rows,
            ahead,
            more,
            row: Row::default(),
            wanted,
            clock,
            marks,
            watch: Watch::default(),
            ended: false,
        };
        if let Some(mut clock) = log.clock.clone() {
            let mut times = log.ahead.iter().rev().take(AHEAD).map(|row| clock.time_s(row));
            let _ = times.find(|time| matches!(time, Ok(Some(_))));
            drop(times);
            log.start = clock.start().or(log.start);
        }
        Ok(log)
    }

    /// The unit in which a quantity is logged.
    pub(crate) fn unit(&self, quantity: Quantity) -> Option<&'static Unit> {
        let wanted = self.wanted.iter().find(|(wanted, _)| wanted.quantity == quantity);
        wanted.map(|(wanted, _)| wanted.unit)
    }

    /// Whether a channel gives a quantity.
    pub fn has(&self, quantity: Quantity) -> bool {
        self.channels.iter().any(|channel| channel.quantity == Some(quantity))
    }

    /// Returns the first of the choices that are missing before rows can be read, as an error.
    pub(crate) fn ask(&mut self) -> Result<(), ImportError> {
        if self.asked.is_empty() {
            return Ok(());
        }
        Err(ImportError::new(&self.file, None, self.asked.swap_remove(0)))
    }

    /// Number of rows returned so far.
    pub fn rows(&self) -> u64 {
        self.watch.rows()
    }

    fn next_record(&mut self) -> Result<Option<Record>, ImportError> {
        loop {
            let more = match self.ahead.pop() {
                Some(row) => {
                    self.row = row;
                    true
                }
                None if self.more => self.rows.next(&mut self.row, &mut self.notes)?,
                None => false,
            };
            if !more {
                self.ended = true;
                let finished = self.watch.finish(&mut self.notes);
                let at = |kind| ImportError::new(&self.file, None, kind);
                return finished.map(|()| None).map_err(at);
            }
            let mut record = Record::NONE;
            if self.clock.is_some() {
                let Some(time_s) = self.time_s()? else { continue };
                record.time_s = time_s;
            }
            for (wanted, nulls) in &self.wanted {
                let cell = self.row.cell(wanted.column);
                if cell.is_empty() {
                    continue;
                }
                let Some(value) = marked(cell, self.marks) else {
                    if is_nothing(cell) {
                        if cell.eq_ignore_ascii_case(b"bad") {
                            self.watch.bad(self.row.line);
                        }
                        continue;
                    }
                    let kind = ImportErrorKind::NotANumber {
                        what: format!(
                            "{} {}",
                            wanted.quantity.words(),
                            self.channels[wanted.column].mnemonic
                        ),
                        found: short(cell),
                    };
                    return Err(self.error(kind));
                };
                if nulls.contains(&value) {
                    continue;
                }
                if value < -800.0 && is_null(value) {
                    self.watch.usual_null(value, self.row.line);
                    continue;
                }
                if self.marks == Marks::Either && has_comma(cell) {
                    self.watch.comma(self.row.line);
                }
                *wanted.quantity.field(&mut record) = wanted.unit.to_si(value);
            }
            self.watch.given();
            return Ok(Some(record));
        }
    }

    /// Time of the row; `None` if it has none or goes back.
    fn time_s(&mut self) -> Result<Option<f64>, ImportError> {
        let Some(clock) = &mut self.clock else { return Ok(None) };
        let line = self.row.line;
        let time_s = match clock.time_s(&self.row) {
            Ok(time_s) => time_s,
            Err(found) => {
                let sentence = format!("'{found}' is not a time in the format of the rows above");
                return Err(self.error(ImportErrorKind::Refused(sentence)));
            }
        };
        Ok(self.watch.time_s(time_s, line))
    }

    fn error(&self, kind: ImportErrorKind) -> ImportError {
        ImportError::new(&self.file, Some(format!("line {}", self.row.line)), kind)
    }
}

impl Iterator for Log<'_> {
    type Item = Result<Record, ImportError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let next = self.next_record().transpose();
        self.ended |= matches!(next, Some(Err(_)));
        next
    }
}

/// Whether the times of the first rows decrease from row to row.
fn is_newest_first(clock: &Clock, rows: &[Row]) -> bool {
    /// Step above which a clock without a date has passed midnight, s.
    const LONGEST_STEP_S: f64 = 43_200.0;
    let mut clock = clock.clone();
    let times: Vec<f64> = rows.iter().filter_map(|row| clock.time_s(row).ok().flatten()).collect();
    let steps = times.windows(2).map(|pair| pair[1] - pair[0]);
    let steps: Vec<f64> = steps.filter(|step| step.abs() < LONGEST_STEP_S).collect();
    let back = steps.iter().filter(|step| **step < 0.0).count();
    let forth = steps.iter().filter(|step| **step > 0.0).count();
    back >= 2 && 20 * forth <= back
}

/// Reads the remaining rows after those read in advance; there are no more afterwards.
fn read_all(
    rows: &mut dyn Rows,
    ahead: &mut Vec<Row>,
    notes: &mut Vec<Note>,
    file: &str,
) -> Result<bool, ImportError> {
    let mut bytes = 0;
    loop {
        let mut row = Row::default();
        if !rows.next(&mut row, notes)? {
            return Ok(false);
        }
        bytes += row.bytes.len() + std::mem::size_of_val(row.cells.as_slice());
        if bytes > SORTED_BYTES {
            let sentence = format!(
                "the log runs newest first and has more than {} MB; expected rows in the order of \
                 time (sort it by its time)",
                SORTED_BYTES >> 20
            );
            return Err(ImportError::new(file, None, ImportErrorKind::Refused(sentence)));
        }
        row.bytes.shrink_to_fit();
        row.cells.shrink_to_fit();
        ahead.push(row);
    }
}

fn has_comma(cell: &[u8]) -> bool {
    cell.contains(&b',') && cell.iter().all(|b| b.is_ascii_digit() || b",.-+".contains(b))
}

/// Beginning of a cell, for a sentence.
pub(crate) fn short(cell: &[u8]) -> String {
    let text = super::lines::text(&cell[..cell.len().min(160)]);
    let mut short: String = text.chars().take(40).collect();
    if text.chars().count() > 40 || cell.len() > 160 {
        short.push('…');
    }
    short
}
