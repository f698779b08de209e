//! A row of cells, as it is read.

use crate::{error::ImportError, fragment::Note};

/// Columns of a row. A rig has hundreds of channels.
pub(crate) const COLUMNS: usize = 4096;

/// The cells of a row: one text, and where in it they lie.
#[derive(Debug, Clone, Default)]
pub(crate) struct Row {
    pub(crate) bytes: Vec<u8>,
    pub(crate) cells: Vec<(u32, u32)>,
    /// The line in which it begins, from 1.
    pub(crate) line: u64,
}

impl Row {
    /// Makes room for the next.
    pub(crate) fn clear(&mut self) {
        self.bytes.clear();
        self.cells.clear();
    }

    /// A cell without blanks around it; empty where the row is shorter.
    pub(crate) fn cell(&self, column: usize) -> &[u8] {
        let range = self.cells.get(column);
        range.map_or(&[][..], |&(from, to)| &self.bytes[from as usize..to as usize])
    }

    /// Adds the cell that lies there, without blanks and quotation marks around it.
    pub(crate) fn push(&mut self, mut from: usize, mut to: usize) {
        let blank = |b: u8| b.is_ascii_whitespace();
        while from < to && blank(self.bytes[from]) {
            from += 1;
        }
        while from < to && blank(self.bytes[to - 1]) {
            to -= 1;
        }
        if to - from >= 2 && self.bytes[from] == b'"' && self.bytes[to - 1] == b'"' {
            return self.push(from + 1, to - 1);
        }
        self.cells.push((from as u32, to as u32));
    }

    /// Parts what lies behind `from` at a sign; false where a quotation stays open.
    ///
    /// A quotation begins a cell: the inches of `9 5/8"` open none.
    pub(crate) fn part_at(&mut self, sign: u8, from: usize) -> bool {
        let mut start = from;
        let mut open = false;
        let mut blank = true;
        for at in from..self.bytes.len() {
            let byte = self.bytes[at];
            if byte == sign && !open {
                self.push(start, at);
                start = at + 1;
                blank = true;
                continue;
            }
            if byte == b'"' && (open || blank) {
                open = !open;
            }
            blank &= byte.is_ascii_whitespace();
        }
        self.push(start, self.bytes.len());
        !open
    }

    /// Parts what lies behind `from` at blanks; quotation marks hold words together.
    pub(crate) fn part_at_blanks(&mut self, from: usize) {
        let end = self.bytes.len();
        let mut at = from;
        loop {
            while at < end && self.bytes[at].is_ascii_whitespace() {
                at += 1;
            }
            if at == end {
                return;
            }
            let start = at;
            let mut open = self.bytes[at] == b'"';
            at += 1;
            while at < end && (open || !self.bytes[at].is_ascii_whitespace()) {
                open &= self.bytes[at] != b'"';
                at += 1;
            }
            self.push(start, at);
        }
    }
}

/// What gives the rows of a log, one after the other.
pub(crate) trait Rows {
    /// Reads the next row; false where there is none. Notes are what is to be said of the rows.
    fn next(&mut self, row: &mut Row, notes: &mut Vec<Note>) -> Result<bool, ImportError>;
}
