//! Checks before the records of old workbooks (`.xls`) are read.
//!
//! The reader of workbooks allocates a table for every named sheet, as large as its farthest cells
//! and its own claim, and copies a shared string into each cell that refers to it. All of this is
//! therefore counted first. Claims of extent, names and formulas, which are not needed, are
//! removed. Hidden contents and formulas without results are collected at the same time.
//!
//! Format: \[MS-XLS\] Excel Binary File Format.

use std::collections::{BTreeSet, HashSet};

use crate::cells::compound::{u16_at, u32_at};
use crate::cells::limits::{self, Budget, too_much};
use crate::cells::shown::Shown;
use crate::error::TableErrorKind;

/// Kinds of records.
const FORMULA: u16 = 0x0006;
const END: u16 = 0x000a;
const NAME: u16 = 0x0018;
const CONTINUE: u16 = 0x003c;
const COLUMN_FORMAT: u16 = 0x007d;
const SHEET: u16 = 0x0085;
const MANY_NUMBERS: u16 = 0x00bd;
const STRINGS: u16 = 0x00fc;
const SHARED_TEXT: u16 = 0x00fd;
const EXTENT: u16 = 0x0200;
const TEXT: u16 = 0x0207;
const ROW_FORMAT: u16 = 0x0208;
const BEGIN: u16 = 0x0809;

/// A kind that readers ignore.
const NOTHING: u16 = 0xffff;

/// Bytes of a formula's record before its expression.
const FORMULA_HEAD: usize = 20;

/// Maximum number of columns of a sheet; row numbers have 16 bits.
const COLUMNS: u16 = 256;

/// Refuses a workbook with more cells than the limits or beyond the format, and removes records
/// that would cause excessive allocation. Bytes after the last whole record are cut off, because a
/// padded sector would make them an unchecked record. Returns the visible contents of each sheet,
/// in the order of the workbook.
pub(crate) fn check(stream: &mut Vec<u8>) -> Result<Vec<Shown>, TableErrorKind> {
    let all: Vec<Record> = records(stream, 0).collect();
    let end = all.last().ok_or_else(|| damaged("its workbook holds no record"))?.to;
    stream.truncate(end);
    let head = all.iter().position(|record| record.kind == END);
    let head = &all[..head.unwrap_or(all.len())];
    let sheets: Vec<u32> = head
        .iter()
        .filter(|record| record.kind == SHEET)
        .filter_map(|record| u32_at(record.data(stream), 0))
        .collect();
    if sheets.len() > limits::SHEETS {
        return Err(too_much(sheets.len(), "sheets", limits::SHEETS));
    }
    let strings = string_lengths(head, stream);
    // If a sheet began within a record, removing that record would change its cells.
    let begins: HashSet<usize> = all.iter().map(|record| record.from - 4).collect();
    let mut budget = Budget::default();
    let mut views = Vec::new();
    for sheet in sheets {
        let start = sheet as usize;
        if !begins.contains(&start) {
            return Err(damaged("a sheet does not begin with a record"));
        }
        views.push(count(stream, start, &strings, &mut budget)?);
    }
    // Excel writes empty texts and zeros as results. If no formula of the workbook has another
    // result, they are placeholders of a program that calculates none.
    let is_calculated = views.iter().any(|view| view.has_result);
    let visible = views.into_iter().map(|mut view| {
        if !is_calculated {
            view.shown.uncalculated = view.placeholders;
        }
        view.shown
    });
    let visible = visible.collect();
    for record in all {
        let length = record.to - record.from;
        match record.kind {
            EXTENT => stream[record.from..record.to].fill(0),
            NAME => {
                stream[record.from - 4..record.from - 2].copy_from_slice(&NOTHING.to_le_bytes());
            }
            // The length of its expression.
            FORMULA if length >= FORMULA_HEAD + 2 => {
                stream[record.from + FORMULA_HEAD..][..2].fill(0);
            }
            _ => {}
        }
    }
    Ok(visible)
}

/// Information collected on a sheet while its cells are counted.
#[derive(Default)]
struct View {
    shown: Shown,
    /// Formulas whose result is an empty text, or a zero that is to be recalculated.
    placeholders: BTreeSet<(u32, u32)>,
    /// Whether a formula has another result.
    has_result: bool,
}

impl View {
    fn take(&mut self, kind: u16, data: &[u8]) {
        match kind {
            // Row, two columns, height, four bytes, options.
            ROW_FORMAT => {
                let (Some(row), Some(options)) = (u16_at(data, 0), u16_at(data, 12)) else {
                    return;
                };
                if options & 0x20 != 0 {
                    self.shown.hidden_rows.insert(u32::from(row));
                }
            }
            // First and last column, width, format, options.
            COLUMN_FORMAT => {
                let number = |at| u16_at(data, at);
                let [Some(first), Some(last), Some(width), Some(options)] =
                    [0, 2, 4, 8].map(number)
                else {
                    return;
                };
                if options & 1 != 0 || width == 0 {
                    self.shown.hide_columns(u32::from(first), u32::from(last));
                }
            }
            // Row, column, format, result in eight bytes, options.
            FORMULA => {
                let (Some(row), Some(column)) = (u16_at(data, 0), u16_at(data, 2)) else { return };
                let (Some(low), Some(high)) = (u32_at(data, 6), u32_at(data, 10)) else { return };
                let options = u16_at(data, 14).unwrap_or(0);
                let is_empty_text = high >> 16 == 0xffff && low & 0xff == 3;
                let is_zero = low == 0 && high == 0;
                // Bit 1: to be calculated when the workbook is opened.
                if is_empty_text || (is_zero && options & 2 != 0) {
                    self.placeholders.insert((u32::from(row), u32::from(column)));
                } else if !is_zero {
                    self.has_result = true;
                }
            }
            _ => {}
        }
    }
}

/// Counts the cells of a sheet, and collects its hidden contents.
fn count(
    stream: &[u8],
    start: usize,
    strings: &[usize],
    budget: &mut Budget,
) -> Result<View, TableErrorKind> {
    let mut view = View::default();
    let (mut cells, mut formulas) = (Extent::default(), Extent::default());
    // Cell of the preceding formula, whose text is in a record of its own.
    let mut at = (0, 0);
    let mut depth = 0_usize;
    for record in records(stream, start) {
        let data = record.data(stream);
        view.take(record.kind, data);
        match record.kind {
            BEGIN => depth += 1,
            // A chart within the sheet ends before it does.
            END if depth > 1 => depth -= 1,
            END => break,
            EXTENT if !is_extent(data) => {
                return Err(damaged("a sheet claims more than the format has"));
            }
            TEXT => {
                budget.cells(1)?;
                cells.take(at.0, at.1, at.1);
            }
            _ => {}
        }
        let Some((row, first, last)) = place(record.kind, data) else {
            continue;
        };
        if last >= COLUMNS || last < first {
            return Err(damaged("a cell is beyond the format's last column"));
        }
        budget.cells(usize::from(last - first) + 1)?;
        cells.take(row, first, last);
        if record.kind == FORMULA {
            formulas.take(row, first, last);
            at = (row, first);
        }
        if record.kind == SHARED_TEXT {
            let index = u32_at(data, 6).map_or(usize::MAX, |index| index as usize);
            budget.text(strings.get(index).copied().unwrap_or(0))?;
        }
    }
    // A table has all the cells between its corners.
    budget.cells(cells.area())?;
    budget.cells(formulas.area())?;
    Ok(view)
}

/// Row, first and last column of the cells in a record, if it has any.
fn place(kind: u16, data: &[u8]) -> Option<(u16, u16, u16)> {
    let (row, first) = (u16_at(data, 0)?, u16_at(data, 2)?);
    match kind {
        // Number, Label, RString, BoolErr, RK, LabelSst, Formula.
        0x0203 | 0x0204 | 0x00d6 | 0x0205 | 0x027e | SHARED_TEXT | FORMULA => {
            Some((row, first, first))
        }
        // Row, first column, six bytes for each number, last column.
        MANY_NUMBERS => {
            let numbers = data.len().saturating_sub(6) / 6;
            let by_length = usize::from(first) + numbers.max(1) - 1;
            let stated = u16_at(data, data.len().checked_sub(2)?)?;
            Some((row, first, stated.max(by_length.min(usize::from(u16::MAX)) as u16)))
        }
        _ => None,
    }
}

/// Whether a claim of extent is within the format's limits: first row, row after the last, first
/// column, column after the last.
fn is_extent(data: &[u8]) -> bool {
    let (first, after, columns) = if data.len() < 14 {
        let wide = |at| u16_at(data, at).map(u32::from);
        (wide(0), wide(2), u16_at(data, 6))
    } else {
        (u32_at(data, 0), u32_at(data, 4), u16_at(data, 10))
    };
    let rows = u32::from(u16::MAX) + 1;
    after.is_none_or(|after| after <= rows && (after == 0 || first < Some(after)))
        && columns.is_none_or(|columns| columns <= COLUMNS)
}

/// The smallest rectangle around cells: first and last row and column.
#[derive(Default)]
struct Extent(Option<[u16; 4]>);

impl Extent {
    fn take(&mut self, row: u16, first: u16, last: u16) {
        let [top, bottom, left, right] = self.0.unwrap_or([row, row, first, last]);
        self.0 = Some([top.min(row), bottom.max(row), left.min(first), right.max(last)]);
    }

    fn area(&self) -> usize {
        let Some([top, bottom, left, right]) = self.0 else {
            return 0;
        };
        (usize::from(bottom - top) + 1) * (usize::from(right - left) + 1)
    }
}

/// Lengths of the shared strings, upper limit in bytes, as far as they are valid.
fn string_lengths(head: &[Record], stream: &[u8]) -> Vec<usize> {
    // The last such record counts.
    let Some(at) = head.iter().rposition(|record| record.kind == STRINGS) else {
        return Vec::new();
    };
    let more = head[at + 1..].iter();
    let more = more.take_while(|record| record.kind == CONTINUE);
    let pieces = std::iter::once(&head[at]).chain(more);
    let mut strings =
        Strings { pieces: pieces.map(|record| record.data(stream)).collect(), piece: 0, at: 8 };
    let mut lengths = Vec::new();
    while let Some(length) = strings.next_length() {
        lengths.push(length);
    }
    lengths
}

/// Iterator over the shared strings.
struct Strings<'a> {
    pieces: Vec<&'a [u8]>,
    piece: usize,
    at: usize,
}

impl Strings<'_> {
    /// Returns the number of bytes of the next string as text, at most three per letter.
    fn next_length(&mut self) -> Option<usize> {
        while self.at >= self.pieces.get(self.piece)?.len() {
            (self.piece, self.at) = (self.piece + 1, 0);
        }
        let here = &self.pieces[self.piece][self.at..];
        let letters = usize::from(u16_at(here, 0)?);
        let flags = *here.get(2)?;
        self.at += 3;
        let mut after = 0_usize;
        for (flag, size) in [(8, 2), (4, 4)] {
            if flags & flag != 0 {
                let here = self.pieces[self.piece].get(self.at..)?;
                // Formatting runs of four bytes each, and phonetic data.
                after += match size {
                    2 => 4 * usize::from(u16_at(here, 0)?),
                    _ => u32_at(here, 0)? as usize,
                };
                self.at += size;
            }
        }
        let (mut left, mut wide) = (letters, flags & 1 != 0);
        while left > 0 {
            let there = self.pieces[self.piece].len().saturating_sub(self.at);
            let width = if wide { 2 } else { 1 };
            let taken = left.min(there / width);
            self.at += taken * width;
            left -= taken;
            if left > 0 {
                // Each continuation states the width of its letters.
                self.piece += 1;
                wide = *self.pieces.get(self.piece)?.first()? & 1 != 0;
                self.at = 1;
            }
        }
        while after > 0 {
            let there = self.pieces[self.piece].len().saturating_sub(self.at);
            let skipped = after.min(there);
            (self.at, after) = (self.at + skipped, after - skipped);
            if after > 0 {
                (self.piece, self.at) = (self.piece + 1, 0);
                self.pieces.get(self.piece)?;
            }
        }
        Some(3 * letters)
    }
}

/// A record: its kind, and the range of its data.
#[derive(Clone, Copy)]
struct Record {
    kind: u16,
    from: usize,
    to: usize,
}

impl Record {
    fn data<'a>(&self, stream: &'a [u8]) -> &'a [u8] {
        &stream[self.from..self.to]
    }
}

/// The records of a stream from an offset on.
fn records(stream: &[u8], from: usize) -> impl Iterator<Item = Record> + '_ {
    let mut at = from;
    std::iter::from_fn(move || {
        let kind = u16_at(stream, at)?;
        let length = usize::from(u16_at(stream, at + 2)?);
        let from = at + 4;
        at = from.checked_add(length).filter(|to| *to <= stream.len())?;
        Some(Record { kind, from, to: at })
    })
}

fn damaged(reason: &str) -> TableErrorKind {
    TableErrorKind::NotAWorkbook { reason: reason.to_owned() }
}
