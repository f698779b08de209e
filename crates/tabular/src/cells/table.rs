//! A file as rows of cells with their positions.

use crate::cells::number;
use crate::error::{Place, TableError, TableErrorKind};

/// Separator of the cells of a text in columns separated by blanks, in words.
pub(crate) const BLANKS: &str = "blanks";

/// Position of a cell in its file: the range of bytes of a text, or row and column of a sheet, from
/// 0. Its [`Source`] determines which of the two it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Position(pub(crate) usize, pub(crate) usize);

/// One cell.
#[derive(Debug, Clone)]
pub(crate) struct Cell {
    /// Its text, trimmed.
    pub(crate) text: String,
    /// Its number, if the file contains one in place of a text.
    pub(crate) number: Option<f64>,
    pub(crate) at: Position,
    /// Whether it is a formula whose result was never calculated, which readers of values see as
    /// empty.
    pub(crate) is_uncalculated: bool,
}

impl Cell {
    /// A cell of a text.
    pub(crate) fn new(text: String, at: Position) -> Self {
        Self { text, number: None, at, is_uncalculated: false }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.text.is_empty()
    }
}

/// One row.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) cells: Vec<Cell>,
    /// Position of a cell that the row lacks.
    pub(crate) end: Position,
}

impl Row {
    pub(crate) fn is_empty(&self) -> bool {
        self.cells.iter().all(Cell::is_empty)
    }

    pub(crate) fn text(&self, index: usize) -> &str {
        self.cells.get(index).map_or("", |cell| &cell.text)
    }

    /// The texts of its cells that are not empty.
    pub(crate) fn texts(&self) -> impl Iterator<Item = &str> {
        self.cells.iter().map(|cell| cell.text.as_str()).filter(|text| !text.is_empty())
    }

    /// Whether it begins with a comment sign: [`is_comment`].
    pub(crate) fn is_comment(&self) -> bool {
        let mut texts = self.texts();
        is_comment(texts.next().unwrap_or(""), texts.next().is_some())
    }

    /// Whether it is a line drawn with signs, such as `-----`.
    pub(crate) fn is_rule(&self) -> bool {
        let mut signs = self.texts().flat_map(str::chars).filter(|c| !c.is_whitespace()).peekable();
        signs.peek().is_some() && signs.all(|c| "-=_*+|".contains(c))
    }
}

/// Values of cells that a spreadsheet could not calculate.
const ERRORS: [&str; 11] = [
    "#n/a",
    "#value!",
    "#ref!",
    "#div/0!",
    "#num!",
    "#name?",
    "#null!",
    "#spill!",
    "#calc!",
    "#field!",
    "#getting_data",
];

/// Whether a row is a comment, by the text of its first cell and whether more cells follow: it
/// begins with `#`, `%`, `~` or `//`. An error of a spreadsheet such as `#N/A` is a value that is
/// missing, and `#3` in a row with more cells is its number.
///
/// ```
/// use wholestring_tabular::is_comment;
///
/// assert!(is_comment("# depths by wireline", false));
/// assert!(!is_comment("#N/A", true) && !is_comment("#3", true));
/// ```
pub fn is_comment(first: &str, more: bool) -> bool {
    let is_number =
        |rest: &str| !rest.is_empty() && rest.chars().all(|letter| letter.is_ascii_digit());
    match first.strip_prefix('#') {
        Some(rest) => {
            let is_error = || ERRORS.iter().any(|error| first.eq_ignore_ascii_case(error));
            !(is_error() || more && is_number(rest.trim()))
        }
        None => first.starts_with(['%', '~']) || first.starts_with("//"),
    }
}

/// A table and its file.
#[derive(Debug, Clone)]
pub(crate) struct Table<'a> {
    pub(crate) source: Source<'a>,
    pub(crate) rows: Vec<Row>,
    /// Separator of the cells of a text, in words.
    pub(crate) parted_by: Option<&'static str>,
    /// Number of values required in every row, if cells are counted and not separated by a sign.
    pub(crate) counted: Option<usize>,
    /// Notes on text that was skipped when the rows were cut.
    pub(crate) notes: Vec<String>,
}

impl Table<'_> {
    /// Checks that the cells of columns, from a row on, are all calculated.
    ///
    /// # Errors
    /// The first cell that is not.
    pub(crate) fn check_calculated(
        &self,
        columns: &[usize],
        from: usize,
    ) -> Result<(), TableError> {
        let rows = self.rows.iter().skip(from);
        let mut cells = rows.flat_map(|row| {
            row.cells.iter().enumerate().filter(|(index, _)| columns.contains(index))
        });
        match cells.find(|(_, cell)| cell.is_uncalculated) {
            Some((_, cell)) => {
                Err(self.source.error(TableErrorKind::FormulaNotCalculated, Some(cell.at)))
            }
            None => Ok(()),
        }
    }

    /// Checks that a row of data has no more cells than the header has columns: a separator of
    /// thousands that also separates cells moves every value after it into another column. Empty
    /// cells at the end do not count. Cells of a workbook are in their columns in any case.
    /// `is_of_numbers` is whether the column at an index is one of numbers.
    ///
    /// # Errors
    /// The first cell beyond the columns, or the number that was probably cut.
    pub(crate) fn check_width(
        &self,
        row: &Row,
        header: &[String],
        is_of_numbers: impl Fn(usize) -> bool,
    ) -> Result<(), TableError> {
        let Some(sign) = self.parted_by else { return Ok(()) };
        let end = |filled: Option<usize>| filled.map_or(0, |last| last + 1);
        let headed = end(header.iter().rposition(|text| !text.is_empty()));
        let expected = headed.max(self.counted.unwrap_or(0));
        let found = end(row.cells.iter().rposition(|cell| !cell.is_empty()));
        if headed == 0 || found <= expected {
            return Ok(());
        }
        let beyond = row.cells[expected..found].iter().filter(|cell| !cell.is_empty());
        let first = beyond.clone().next().unwrap_or(&row.cells[found - 1]);
        let mut pairs = row.cells[..found].windows(2);
        let split = pairs.find(|pair| number::is_cut_at_thousands(&pair[0].text, &pair[1].text));
        // Text behind the numbers of a row is a remark: in a column of the header without a heading,
        // after columns separated by blanks, or next to the last column if that is one of numbers.
        let is_number = |cell: &Cell| number::is_number(&cell.text);
        let is_remark = !beyond.clone().any(is_number) && is_of_numbers(expected - 1);
        let may_be_remark = found <= header.len() || sign == BLANKS;
        if is_remark || (may_be_remark && (split.is_none() || !beyond.clone().all(is_number))) {
            return Ok(());
        }
        let kind = TableErrorKind::LongRow {
            found,
            expected,
            first: first.text.clone(),
            split: split.map(|pair| [0, 1].map(|place: usize| pair[place].text.clone())),
        };
        let at = split.map_or(first.at, |pair| pair[0].at);
        Err(self.source.error(kind, Some(at)))
    }

    /// A note on an item found, and on the separator of cells.
    pub(crate) fn note(&self, found: &str) -> String {
        match self.parted_by {
            Some(sign) => format!("{found}, columns separated by {sign}"),
            None => found.to_owned(),
        }
    }
}

/// A text or a sheet of a workbook.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Source<'a> {
    Text {
        file: &'a str,
        text: &'a str,
    },
    /// `unread`: contents of the sheet that are not read and might be missed, in words.
    Sheet {
        file: &'a str,
        sheet: &'a str,
        unread: &'a str,
    },
}

impl Source<'_> {
    /// The error of this kind at a position.
    pub(crate) fn error(&self, kind: TableErrorKind, at: Option<Position>) -> TableError {
        let place = at.map(|at| self.place(at));
        match *self {
            Source::Text { file, text } => TableError::new(file, kind, place, Some(text)),
            Source::Sheet { file, unread, .. } => {
                TableError::new(file, kind, place, None).with_unread(unread)
            }
        }
    }

    /// The place of a position.
    pub(crate) fn place(&self, at: Position) -> Place {
        let Position(first, second) = at;
        match *self {
            Source::Text { text, .. } => {
                let before = &text[..first];
                let line_start = line_starts(before).last().unwrap_or(0);
                Place::Text {
                    line: line_starts(before).count(),
                    column: before[line_start..].chars().count() + 1,
                    span: first..second,
                }
            }
            Source::Sheet { sheet, .. } => Place::Cell {
                sheet: sheet.to_owned(),
                row: first as u32 + 1,
                column: second as u32 + 1,
            },
        }
    }

    /// The rows from one position to another, in words.
    pub(crate) fn rows_name(&self, first: Position, last: Position) -> String {
        match (self.place(first), self.place(last)) {
            (Place::Text { line: first, .. }, Place::Text { line: last, .. }) => {
                format!("lines {first} to {last}")
            }
            (Place::Cell { row: first, sheet, .. }, Place::Cell { row: last, .. }) => {
                format!("rows {first} to {last} of sheet '{sheet}'")
            }
            _ => self.row_name(first),
        }
    }

    /// The row of a position, in words.
    pub(crate) fn row_name(&self, at: Position) -> String {
        match self.place(at) {
            Place::Text { line, .. } => format!("line {line}"),
            Place::Cell { row, sheet, .. } => format!("row {row} of sheet '{sheet}'"),
        }
    }
}

/// Beginnings of the lines of a text: after `\n`, `\r\n` or a lone `\r`.
pub(crate) fn line_starts(text: &str) -> impl Iterator<Item = usize> {
    let bytes = text.as_bytes();
    let ends = bytes.iter().enumerate().filter_map(|(i, byte)| match byte {
        b'\n' => Some(i + 1),
        b'\r' if bytes.get(i + 1) != Some(&b'\n') => Some(i + 1),
        _ => None,
    });
    std::iter::once(0).chain(ends)
}
