//! Formats of an export, and exported data written in them.

use std::path::{Path, PathBuf};

use wholestring_export::{Look, Version, number};
use wholestring_report::{Cells, Sheet, Workbook};
use wholestring_results::{ResultsFolder, write_file};

use crate::error::Error;

/// Part of a case or of its results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// Tables of a folder of results; in WITSML, hook load and torque against bit depth.
    Results,
    /// Survey stations of the well.
    Survey,
    /// Components of the string, from the bit up.
    Tally,
}

/// Format of the export.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated text with units in the headings.
    Csv,
    /// An Excel workbook.
    Xlsx,
    /// Columns of fixed width, as in survey reports.
    Text,
    /// WITSML in one of its versions.
    Witsml(Version),
}

impl Format {
    /// Extension of the files.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Xlsx => "xlsx",
            Self::Text => "txt",
            Self::Witsml(_) => "xml",
        }
    }

    pub(super) fn version(self) -> Option<Version> {
        match self {
            Self::Witsml(version) => Some(version),
            Self::Csv | Self::Xlsx | Self::Text => None,
        }
    }
}

// Exported data, and writing them to the disk.

/// Exported data before they are written.
pub(super) enum Made {
    /// One file.
    File(Vec<u8>),
    /// Several files, by the stems of their names.
    Files(Vec<(String, Vec<u8>)>),
}

impl Made {
    /// Writes the data to a file or folder of that name; without a name, next to their source.
    pub(super) fn write(
        self,
        from: &Path,
        output: Option<&PathBuf>,
        what: What,
        format: Format,
    ) -> Result<Vec<PathBuf>, Error> {
        let ending = format.ending();
        let stem = match what {
            What::Results => "results",
            What::Survey => "survey",
            What::Tally => "tally",
        };
        match self {
            Self::File(content) => {
                let path = output.cloned().unwrap_or_else(|| {
                    let name = format!("{stem}.{ending}");
                    match from.is_dir() {
                        true => from.join(name),
                        false => beside(from, &name),
                    }
                });
                write_file(&path, &content)?;
                Ok(vec![path])
            }
            Self::Files(files) => {
                let folder = output.cloned().unwrap_or_else(|| from.join("export"));
                let folder = ResultsFolder::create(folder)?;
                files
                    .into_iter()
                    .map(|(stem, content)| {
                        let name = format!("{stem}.{ending}");
                        folder.write_file(&name, &content)?;
                        Ok(folder.path().join(name))
                    })
                    .collect()
            }
        }
    }
}

/// `CASE-survey.csv` next to `CASE.toml`.
fn beside(case: &Path, name: &str) -> PathBuf {
    let stem = case.file_stem().unwrap_or_default().to_string_lossy();
    case.with_file_name(format!("{stem}-{name}"))
}

/// One table, as CSV or as a workbook.
pub(super) fn one_table(
    table: &wholestring_results::Table,
    name: &str,
    about: &str,
    look: &Look,
    format: Format,
) -> Result<Made, Error> {
    let sheet = crate::sheet::sheet(name, table, about, look.units);
    if format == Format::Csv {
        return Ok(Made::File(csv(&sheet).into_bytes()));
    }
    let workbook = Workbook {
        title: look.name.clone(),
        about: Vec::new(),
        first: Vec::new(),
        charts: Vec::new(),
        sheets: vec![sheet],
        printed_rows: None,
    };
    Ok(Made::File(workbook.bytes().map_err(Error::failed)?))
}

// A sheet as CSV.

/// The sheet as CSV: headings with units in brackets, which the table reader accepts.
pub(super) fn csv(sheet: &Sheet) -> String {
    let head = |column: &wholestring_report::SheetColumn| match column.unit.as_str() {
        "" => column.heading.clone(),
        unit => format!("{} ({unit})", column.heading),
    };
    let headings = sheet.columns.iter().map(|column| quoted(&head(column)));
    let mut text = headings.collect::<Vec<_>>().join(",") + "\n";
    let rows = sheet.columns.first().map_or(0, |column| column.cells.len());
    for row in 0..rows {
        let cells = sheet.columns.iter().map(|column| match &column.cells {
            Cells::Numbers(values) => values[row].and_then(number).unwrap_or_default(),
            Cells::Words(words) => quoted(&words[row]),
        });
        text += &(cells.collect::<Vec<_>>().join(",") + "\n");
    }
    text
}

/// A cell in quotes where it needs them.
fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use wholestring_report::SheetColumn;

    use super::*;

    #[test]
    fn cells_are_quoted_where_they_must_be() {
        let column = |heading: &str, unit: &str, cells| SheetColumn {
            heading: heading.into(),
            unit: unit.into(),
            meaning: String::new(),
            cells,
        };
        let words = ["8 1/2\" bit, PDC", "pipe"].map(str::to_owned).to_vec();
        let sheet = Sheet {
            name: "S".into(),
            about: String::new(),
            columns: vec![
                column("component", "", Cells::Words(words)),
                column("od", "in", Cells::Numbers(vec![Some(8.5), None])),
            ],
        };
        assert_eq!(csv(&sheet), "component,od (in)\n\"8 1/2\"\" bit, PDC\",8.5\npipe,\n");
    }
}
