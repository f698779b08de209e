//! Places of the cells of a table, in words.

use crate::cells::table::{Position, Source, line_starts};

/// Finds the line of a position without scanning the text each time.
pub(crate) struct Lines<'a> {
    source: Source<'a>,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    pub(crate) fn of(source: Source<'a>) -> Self {
        let starts = match source {
            Source::Text { text, .. } => line_starts(text).collect(),
            Source::Sheet { .. } => Vec::new(),
        };
        Self { source, starts }
    }

    /// `line 5`, `row 5 of sheet 'BHA'`.
    pub(crate) fn row(&self, at: Position) -> String {
        match self.source {
            Source::Text { .. } => format!("line {}", self.line(at)),
            Source::Sheet { .. } => self.source.row_name(at),
        }
    }

    /// `line 5, column 'OD'`, `sheet 'BHA', cell C5`.
    pub(crate) fn cell(&self, at: Position, heading: &str) -> String {
        match self.source {
            Source::Text { .. } => format!("line {}, column '{heading}'", self.line(at)),
            Source::Sheet { .. } => self.source.place(at).to_string(),
        }
    }

    fn line(&self, at: Position) -> usize {
        self.starts.partition_point(|&start| start <= at.0)
    }
}
