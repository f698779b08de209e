//! Surveys from CSV, text reports and Excel.
//!
//! Columns are found by their headings, in any order and under the spellings that are common:
//! `MD (m)`, `Measured Depth ( ft )`, `md_m`, `INCL`, `Azimuth Grid [deg]`. Units stand in the
//! headings or in a row below them. Titles and comments above the header, a comma, semicolon, tab
//! or blanks between the columns, decimal commas and thousands separators are taken as they come.
//! What was recognised is told in [`ImportedSurvey::notes`].
//!
//! Nothing is guessed where a mistake would go unseen: lengths without any unit are an error.
//! There are two conventions, and both are noted: angles without a unit are degrees, and a header
//! of just `md,inc,azi`, or no header above three columns, means m, deg, deg.
//!
//! ```
//! let text = "MD (ft),Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n";
//! let survey = wholestring_case::survey::read(text.as_bytes(), "a.csv")?;
//! assert_eq!(survey.stations[1].md_m, 304.8);
//!
//! let error = wholestring_case::survey::read(b"MD (ft),Inc,Azi\n0,0,0\nx,0,0\n", "a.csv");
//! assert_eq!(
//!     error.unwrap_err().to_string(),
//!     "a.csv, line 3, column 1: 'x' is not a number; the measured depth was expected"
//! );
//! # Ok::<(), wholestring_case::survey::SurveyError>(())
//! ```

mod blanks;
mod column;
mod compound;
mod decode;
mod delimited;
mod error;
mod header;
mod heading;
mod layout;
mod names;
mod number;
mod stations;
mod table;
mod workbook;

pub use column::Column;
pub use error::{Place, SurveyError, SurveyErrorKind};

use table::{Source, Table};
use wholestring::well::{Station, TieIn};

/// A survey and how it was understood.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedSurvey {
    /// Two stations or more, by growing measured depth. Azimuths are as written, between -360 and
    /// 720 degrees: they are not wrapped.
    pub stations: Vec<Station>,
    /// Where the first station lies, if the file says so: its true vertical depth, north and east.
    pub tie_in: Option<TieIn>,
    /// What was recognised, assumed and passed over, in sentences for people.
    pub notes: Vec<String>,
}

/// The signs that part cells, in the order in which they are tried.
const SIGNS: [(u8, &str); 3] = [(b'\t', "tabs"), (b';', "semicolons"), (b',', "commas")];

/// Reads a survey: a workbook if its content or its name says so, text otherwise.
///
/// # Errors
/// Everything that [`SurveyErrorKind`] lists, with its place.
pub fn read(bytes: &[u8], name: &str) -> Result<ImportedSurvey, SurveyError> {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    let named_so = ["xlsx", "xlsm", "xlsb", "ods"]
        .iter()
        .any(|workbook| extension.eq_ignore_ascii_case(workbook));
    // A text under the name .xls is common; a workbook by its content is one under any name.
    if workbook::is_workbook(bytes) || (named_so && !bytes.is_empty()) {
        read_excel(bytes, name)
    } else {
        read_csv(bytes, name)
    }
}

/// Reads a survey from text: CSV with any sign between its cells, or a report in columns.
///
/// `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`SurveyErrorKind`] lists but what concerns workbooks, with its place.
pub fn read_csv(bytes: &[u8], name: &str) -> Result<ImportedSurvey, SurveyError> {
    let Some(text) = decode::text(bytes) else {
        return Err(SurveyError::new(name, SurveyErrorKind::NotText, None, None));
    };
    let source = Source::Text {
        file: name,
        text: &text,
    };
    if text.trim().is_empty() {
        return Err(source.error(SurveyErrorKind::Empty, None));
    }

    let mut tables: Vec<Table> = SIGNS
        .iter()
        .filter(|(sign, _)| text.as_bytes().contains(sign))
        .map(|&(sign, parted_by)| delimited::cut(source, &text, sign, parted_by))
        .collect();
    tables.push(blanks::cut(source, &text));
    read_first(&tables).unwrap_or_else(|| Err(source.error(SurveyErrorKind::NoHeader, None)))
}

/// Reads a survey from the bytes of an Excel workbook, `.xlsx` or `.xls`.
///
/// The first sheet with the needed columns is read. `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`SurveyErrorKind`] lists but what concerns text, with its place.
pub fn read_excel(bytes: &[u8], name: &str) -> Result<ImportedSurvey, SurveyError> {
    let sheets =
        workbook::sheets(bytes).map_err(|kind| SurveyError::new(name, kind, None, None))?;
    let tables: Vec<Table> = sheets
        .iter()
        .map(|sheet| Table {
            source: Source::Sheet {
                file: name,
                sheet: &sheet.name,
            },
            rows: sheet.rows.clone(),
            parted_by: None,
            counted: None,
            notes: Vec::new(),
        })
        .collect();
    read_first(&tables).unwrap_or_else(|| {
        let sheets = sheets.into_iter().map(|sheet| sheet.name).collect();
        let kind = SurveyErrorKind::NoSurveySheet { sheets };
        Err(SurveyError::new(name, kind, None, None))
    })
}

/// The first of the tables with a header that names the needed columns; or else the first of three
/// bare columns; or else the error of the header that comes nearest. `None` if none comes near.
fn read_first(tables: &[Table]) -> Option<Result<ImportedSurvey, SurveyError>> {
    let mut nearest: Option<(header::Partial, &Table)> = None;
    for table in tables {
        match header::find(table) {
            Ok(header) => {
                let layout = layout::below(table, header);
                return Some(layout.and_then(|layout| stations::read(table, layout)));
            }
            Err(Some(partial)) => {
                let nearer = nearest
                    .as_ref()
                    .is_none_or(|(best, _)| partial.count > best.count);
                if nearer {
                    nearest = Some((partial, table));
                }
            }
            Err(None) => {}
        }
    }
    // Two columns named are a header; one may be a title's word.
    if nearest
        .as_ref()
        .is_none_or(|(partial, _)| partial.count < 2)
    {
        let bare = tables
            .iter()
            .find_map(|table| Some((table, layout::without_header(table)?)));
        if let Some((table, layout)) = bare {
            return Some(stations::read(table, layout));
        }
    }
    let (partial, table) = nearest.filter(|(partial, _)| partial.is_header())?;
    Some(Err(partial.error(table)))
}
