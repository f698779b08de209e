//! How much of a file is read.
//!
//! A file of some kilobytes can claim, or unpack to, more than any machine has: what it holds is
//! counted and refused before room is made for it. With these limits no survey takes more than a
//! gigabyte.

use crate::error::TableErrorKind;

/// Rows of a table. No survey has so many stations.
pub(crate) const ROWS: usize = 200_000;

/// Columns of a sheet. Cells further to the right are not read, which is said.
pub(crate) const COLUMNS: u32 = 500;

/// Cells of all sheets, or of a text, empty ones between others included.
pub(crate) const CELLS: usize = 1_000_000;

/// Text in all cells, bytes.
pub(crate) const TEXT_BYTES: usize = 64 << 20;

/// What the parts of an `.xlsx` come to when they are unpacked, bytes.
pub(crate) const UNPACKED_BYTES: u64 = 64 << 20;

/// Parts of an `.xlsx`.
pub(crate) const PARTS: usize = 10_000;

/// Tags in the part of an `.xlsx` that holds its styles: Excel has at most 65 490 formats.
pub(crate) const STYLE_TAGS: usize = 1_000_000;

/// The stream of records of an `.xls`, bytes: 65 536 rows of 35 numbers.
pub(crate) const STREAM_BYTES: usize = 32 << 20;

/// Sheets of a workbook.
pub(crate) const SHEETS: usize = 100;

/// The refusal of a file that holds more of something than is read.
pub(crate) fn too_much(found: impl ToString, what: &str, most: impl ToString) -> TableErrorKind {
    TableErrorKind::TooMuch {
        found: format!("{} {what}", found.to_string()),
        most: most.to_string(),
    }
}

/// Cells and text that have been read so far.
#[derive(Debug, Default)]
pub(crate) struct Budget {
    cells: usize,
    text_bytes: usize,
}

impl Budget {
    /// Takes up so many more cells.
    pub(crate) fn cells(&mut self, more: usize) -> Result<(), TableErrorKind> {
        self.cells = self.cells.saturating_add(more);
        if self.cells > CELLS {
            return Err(too_much(format!("more than {CELLS}"), "cells", CELLS));
        }
        Ok(())
    }

    /// Takes up so many more bytes of text.
    pub(crate) fn text(&mut self, more: usize) -> Result<(), TableErrorKind> {
        self.text_bytes = self.text_bytes.saturating_add(more);
        if self.text_bytes > TEXT_BYTES {
            let most = format!("{} MB", TEXT_BYTES >> 20);
            return Err(too_much(format!("more than {most}"), "of text in its cells", most));
        }
        Ok(())
    }
}
