//! Errors of a survey file and their places.

use std::fmt;
use std::ops::Range;

use crate::columns::column::Column;
use wholestring_units::Dimension;

/// Place in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// In a text file.
    Text {
        /// Line, from 1.
        line: usize,
        /// Character within the line, from 1.
        column: usize,
        /// Bytes of [`TableError::text`], on character boundaries.
        span: Range<usize>,
    },
    /// In a workbook.
    Cell {
        /// Name of the sheet.
        sheet: String,
        /// Row, from 1 as spreadsheets number them.
        row: u32,
        /// Column, from 1; spreadsheets write 1 as A.
        column: u32,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Text { line, column, .. } => write!(f, "line {line}, column {column}"),
            Place::Cell { sheet, row, column } => {
                write!(f, "sheet '{sheet}', cell {}{row}", letters(*column))
            }
        }
    }
}

/// Letters of a column in spreadsheets: 1 is A, 27 is AA.
pub(crate) fn letters(column: u32) -> String {
    let mut letters = Vec::new();
    let mut rest = column;
    while rest > 0 {
        rest -= 1;
        letters.push(char::from(b'A' + (rest % 26) as u8));
        rest /= 26;
    }
    letters.iter().rev().collect()
}

/// Ways to give the unit of a survey whose file has none.
const SAY: &str = "`survey_unit = \"m\"` under [well], `--unit m` for `wholestring survey`";

/// Error in a survey.
///
/// Its `Display` is one sentence with the value found and the expected one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TableErrorKind {
    /// The file contains only blanks.
    #[error(
        "the file is empty; a survey with measured depth, inclination and azimuth was expected"
    )]
    Empty,
    /// The bytes are not text.
    #[error("the file is not text; a survey as CSV or as an Excel workbook was expected")]
    NotText,
    /// A file of another format.
    #[error("the file is {what}; a table as CSV or as an Excel workbook was expected")]
    OtherFormat {
        /// Its format, in words.
        what: &'static str,
    },
    /// A workbook that cannot be read.
    #[error(
        "the workbook cannot be read, because {reason}; a whole .xlsx or .xls file was expected, \
         as a spreadsheet program saves it"
    )]
    NotAWorkbook {
        /// Its fault, as a clause.
        reason: String,
    },
    /// A limit on an amount is exceeded.
    #[error("the file holds {found}; at most {most} can be read")]
    TooMuch {
        /// The amount found and its kind.
        found: String,
        /// The limit.
        most: String,
    },
    /// No sheet has the columns.
    #[error(
        "no sheet has columns of measured depth, inclination and azimuth; the sheets are: {}",
        quoted(sheets)
    )]
    NoSurveySheet {
        /// Every sheet's name.
        sheets: Vec<String>,
    },
    /// Neither a header nor three bare columns.
    #[error(
        "no header names the columns; expected one such as \
         'MD (m), Inc (deg), Azi (deg)', or three columns of numbers"
    )]
    NoHeader,
    /// A needed column is missing.
    #[error("no column of {column}{}; the header has: {}", perhaps(nearest), quoted(headers))]
    MissingColumn {
        /// The column.
        column: Column,
        /// The header's cells.
        headers: Vec<String>,
        /// The most similar heading, if there is one.
        nearest: Option<String>,
    },
    /// Two headings name the same column.
    #[error("two columns read as {column}: '{first}' and '{second}'; keep one of them")]
    DuplicateColumn {
        /// The column.
        column: Column,
        /// One heading.
        first: String,
        /// The other.
        second: String,
    },
    /// Three columns of numbers without a header and without a unit of the depths.
    #[error(
        "no header names the columns and their units; write 'MD (m),Inc (deg),Azi (deg)' above \
         them, or give the unit: {SAY}"
    )]
    NoUnits,
    /// Lengths without a unit.
    #[error(
        "the {column} under '{header}' has no unit; write it in the header, such as '{}', or in a \
         row below it, or give it: {SAY}",
        column.example()
    )]
    MissingUnit {
        /// The column.
        column: Column,
        /// Its heading.
        header: String,
    },
    /// A column of readings without a unit.
    #[error(
        "the {column} under '{header}' has no unit; write it in the header, such as '{}', or in a \
         row below it: {}", column.example(), units(column.dimension())
    )]
    MissingReadingUnit {
        /// The column.
        column: Column,
        /// Its heading.
        header: String,
    },
    /// A file without readings.
    #[error(
        "{found}; readings as CSV or as an Excel workbook were expected, under a header such as \
         'Bit depth (m), Pick-up (kN), Slack-off (kN), Rotating (kN), Torque (kN.m)'"
    )]
    NoReadings {
        /// Its contents.
        found: &'static str,
    },
    /// An unknown unit, or one of another dimension.
    #[error("'{found}' is {}not a unit of {}; expected {}", other(*is), column.dimension().name(),
        units(column.dimension()))]
    WrongUnit {
        /// The column.
        column: Column,
        /// The unit as written.
        found: String,
        /// Its dimension, if it is a unit.
        is: Option<Dimension>,
    },
    /// Headings or units in the middle of the table give a column another unit.
    #[error(
        "the {column} is in '{above}' above and in '{below}' from here on; expected one table with \
         one unit in a column: keep its rows and cut off the others"
    )]
    UnitChanges {
        /// The column.
        column: Column,
        /// Symbol of the unit of the table.
        above: &'static str,
        /// Symbol of the unit in the row.
        below: &'static str,
    },
    /// A heading and the row of units contradict each other.
    #[error("the {column} is in '{header}' by its header and in '{row}' by the row of units")]
    UnitConflict {
        /// The column.
        column: Column,
        /// Symbol of the unit in the header.
        header: &'static str,
        /// Symbol of the unit in the row below.
        row: &'static str,
    },
    /// The unit in the file differs from the one given by the user.
    #[error("the {column} is in '{file}' in the file and in '{said}' as given; keep one of them")]
    OtherUnit {
        /// The column.
        column: Column,
        /// Symbol of the unit in the file.
        file: &'static str,
        /// Symbol of the unit given by the user.
        said: &'static str,
    },
    /// A cell that should contain a number.
    #[error("'{found}' is not a number; the {column} was expected")]
    NotANumber {
        /// The column.
        column: Column,
        /// The cell's text.
        found: String,
    },
    /// A formula without its result.
    #[error(
        "the cell holds a formula whose result was never calculated; open the workbook in Excel or \
         LibreOffice and save it"
    )]
    FormulaNotCalculated,
    /// A cell that should not be empty.
    #[error("the {column} is missing in this row")]
    EmptyCell {
        /// The column.
        column: Column,
    },
    /// NaN, an infinity, or a number too large for a double.
    #[error("'{found}' is not a finite number; the {column} was expected")]
    NotFinite {
        /// The column.
        column: Column,
        /// The cell's text.
        found: String,
    },
    /// A separator that may be of thousands or of decimals; nothing in the file decides.
    #[error(
        "'{found}' may mean thousands or decimals; \
         write the numbers with a decimal point and without separators"
    )]
    AmbiguousComma {
        /// The cell's text.
        found: String,
    },
    /// A date in place of a number.
    #[error(
        "the {column} is a date: a spreadsheet made one of a fraction such as 8-1/2, and what was \
         typed is lost; format the cell as a number and type it again as a decimal, such as 8.5"
    )]
    DateCell {
        /// The column.
        column: Column,
    },
    /// A file without a tally.
    #[error(
        "{found}; the components of a string were expected, under a header such as 'Component, OD \
         (in), ID (in), Length (ft), Weight (lb/ft)'"
    )]
    NoTally {
        /// Its contents.
        found: &'static str,
    },
    /// A cell of the column `use` that is neither of the two words.
    #[error("`use` is '{found}', expected \"yes\" or \"no\"")]
    NotYesNo {
        /// The text found.
        found: String,
    },
    /// A row of a table in columns of blanks with fewer values than the others.
    #[error("{found} values in this row, {expected} in the first")]
    ShortRow {
        /// Number of values in the row.
        found: usize,
        /// Number of columns.
        expected: usize,
    },
    /// A row with more cells than the header has columns.
    #[error(
        "{found} cells in this row, but the header has {expected} columns{}",
        match split {
            Some([before, rest]) => format!(
                ": '{before}' and '{rest}' look like one number with thousands; numbers with a \
                 separator of thousands need quotation marks, or another separator between the \
                 columns, such as semicolons"
            ),
            None => format!(
                "; '{first}' is under none of them: add its heading, or put the cell that contains \
                 a separator in quotation marks"
            ),
        }
    )]
    LongRow {
        /// Number of cells in the row, without empty ones at its end.
        found: usize,
        /// Number of columns of the header.
        expected: usize,
        /// The first cell beyond the columns.
        first: String,
        /// Two adjacent cells that look like one number cut at its thousands, if there are any.
        split: Option<[String; 2]>,
    },
    /// A measured depth that does not increase.
    #[error(
        "the measured depth {} after {previous}; it must increase from station to station",
        if found == previous {
            format!("repeats: {found}")
        } else {
            format!("runs backwards: {found}")
        }
    )]
    DepthNotIncreasing {
        /// The depth as written, with its unit.
        found: String,
        /// The depth of the station above.
        previous: String,
    },
    /// A value that is impossible for a hole.
    #[error("the {column} {found} is out of range; expected {expected}")]
    OutOfRange {
        /// The column.
        column: Column,
        /// The value with its unit.
        found: String,
        /// The allowed range.
        expected: &'static str,
    },
    /// Several surveys of which one must be chosen.
    #[error("the file holds {} surveys, one below the other: {}; keep one of them", surveys.len(),
        quoted(surveys))]
    SeveralSurveys {
        /// Their names.
        surveys: Vec<String>,
    },
    /// Too few rows.
    #[error("{}; a survey needs at least two stations", match found {
        0 => "no station follows the header".to_owned(),
        _ => "there is only one station".to_owned(),
    })]
    TooFewStations {
        /// Number of rows.
        found: usize,
    },
}

fn quoted(names: &[String]) -> String {
    const SHOWN: usize = 20;
    let mut text =
        names.iter().take(SHOWN).map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    if names.len() > SHOWN {
        text.push_str(", ...");
    }
    if text.is_empty() { "(none)".to_owned() } else { text }
}

fn perhaps(nearest: &Option<String>) -> String {
    nearest.as_ref().map_or(String::new(), |name| format!(" (is it '{name}'?)"))
}

fn other(is: Option<Dimension>) -> String {
    is.map_or(String::new(), |is| format!("a unit of {}, ", is.name()))
}

fn units(dimension: Dimension) -> String {
    dimension.units().iter().map(|unit| unit.symbol).collect::<Vec<_>>().join(", ")
}

/// Error of a survey file.
///
/// `Display` writes file, place and sentence. To underline the place, use [`text`](Self::text) and
/// the span of [`place`](Self::place), and [`kind`](Self::kind) for the sentence alone.
#[derive(Debug, Clone, PartialEq)]
pub struct TableError(Box<Detail>);

#[derive(Debug, Clone, PartialEq)]
struct Detail {
    file: String,
    kind: TableErrorKind,
    place: Option<Place>,
    text: Option<String>,
    /// Contents of the file that are not read and may be the missing ones.
    unread: Option<String>,
}

impl TableError {
    pub(crate) fn new(
        file: &str,
        kind: TableErrorKind,
        place: Option<Place>,
        text: Option<&str>,
    ) -> Self {
        TableError(Box::new(Detail {
            file: file.to_owned(),
            kind,
            place,
            text: text.map(str::to_owned),
            unread: None,
        }))
    }

    /// Adds the contents of the file that were not read, if they may be the missing ones.
    pub(crate) fn with_unread(mut self, unread: &str) -> Self {
        use TableErrorKind as K;
        let is_missing = matches!(
            self.kind(),
            K::NoSurveySheet { .. }
                | K::NoHeader
                | K::MissingColumn { .. }
                | K::NoUnits
                | K::MissingUnit { .. }
                | K::MissingReadingUnit { .. }
                | K::NoReadings { .. }
                | K::NoTally { .. }
                | K::EmptyCell { .. }
                | K::TooFewStations { .. }
        );
        if is_missing && !unread.is_empty() {
            self.0.unread = Some(unread.to_owned());
        }
        self
    }

    /// Converts the error to that of a file that should contain readings.
    pub(crate) fn of_readings(self) -> Self {
        let found = match self.kind() {
            TableErrorKind::Empty => "the file is empty",
            TableErrorKind::NotText => "the file is not text",
            _ => return self,
        };
        Self::new(self.file(), TableErrorKind::NoReadings { found }, None, None)
    }

    /// The file's name as given to the reader.
    pub fn file(&self) -> &str {
        &self.0.file
    }

    /// Kind of error.
    pub fn kind(&self) -> &TableErrorKind {
        &self.0.kind
    }

    /// The error in a sentence, with the contents of the file that were not read if they may be the
    /// reason.
    pub fn sentence(&self) -> String {
        match &self.0.unread {
            Some(unread) => format!("{} ({unread})", self.kind()),
            None => self.kind().to_string(),
        }
    }

    /// Its place, if it has a single one.
    pub fn place(&self) -> Option<&Place> {
        self.0.place.as_ref()
    }

    /// The whole file as text, to which the span of [`Place::Text`] refers. `None` for workbooks
    /// and for files that are not text.
    ///
    /// It differs from the file's bytes if these are not UTF-8 or begin with a byte order mark.
    pub fn text(&self) -> Option<&str> {
        self.0.text.as_deref()
    }

    /// The bytes of [`text`](Self::text) to underline.
    pub fn span(&self) -> Option<Range<usize>> {
        match self.place() {
            Some(Place::Text { span, .. }) => Some(span.clone()),
            _ => None,
        }
    }
}

impl std::error::Error for TableError {}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place() {
            Some(place) => write!(f, "{}, {place}: {}", self.file(), self.sentence()),
            None => write!(f, "{}: {}", self.file(), self.sentence()),
        }
    }
}
