//! Limits on the size of a file.
//!
//! A file of some kilobytes can claim, or unpack to, more memory than any machine has. Its contents
//! are therefore counted, and refused before memory is allocated. With these limits no survey uses
//! more than a gigabyte.

use crate::error::TableErrorKind;

/// Maximum rows of a table. No survey has as many stations.
pub(crate) const ROWS: usize = 200_000;

/// Maximum columns of a sheet. Cells further to the right are not read, which is noted.
pub(crate) const COLUMNS: u32 = 500;

/// Maximum cells of all sheets, or of a text, including empty ones between others.
pub(crate) const CELLS: usize = 1_000_000;

/// Maximum text in all cells, bytes.
pub(crate) const TEXT_BYTES: usize = 64 << 20;

/// Maximum total size of the unpacked parts of an `.xlsx`, bytes.
pub(crate) const UNPACKED_BYTES: u64 = 64 << 20;

/// Maximum number of parts of an `.xlsx`.
pub(crate) const PARTS: usize = 10_000;

/// Maximum number of tags in the part of an `.xlsx` with its styles: Excel has at most 65 490
/// formats.
pub(crate) const STYLE_TAGS: usize = 1_000_000;

/// Maximum size of the stream of records of an `.xls`, bytes: 65 536 rows of 35 numbers.
pub(crate) const STREAM_BYTES: usize = 32 << 20;

/// Maximum number of sheets of a workbook.
pub(crate) const SHEETS: usize = 100;

/// The error of a file that exceeds a limit.
pub(crate) fn too_much(found: impl ToString, what: &str, most: impl ToString) -> TableErrorKind {
    TableErrorKind::TooMuch {
        found: format!("{} {what}", found.to_string()),
        most: most.to_string(),
    }
}

/// Number of cells and bytes of text read so far.
#[derive(Debug, Default)]
pub(crate) struct Budget {
    cells: usize,
    text_bytes: usize,
}

impl Budget {
    /// Adds this many cells.
    pub(crate) fn cells(&mut self, more: usize) -> Result<(), TableErrorKind> {
        self.cells = self.cells.saturating_add(more);
        if self.cells > CELLS {
            return Err(too_much(format!("more than {CELLS}"), "cells", CELLS));
        }
        Ok(())
    }

    /// Adds this many bytes of text.
    pub(crate) fn text(&mut self, more: usize) -> Result<(), TableErrorKind> {
        self.text_bytes = self.text_bytes.saturating_add(more);
        if self.text_bytes > TEXT_BYTES {
            let most = format!("{} MB", TEXT_BYTES >> 20);
            return Err(too_much(format!("more than {most}"), "of text in its cells", most));
        }
        Ok(())
    }
}
