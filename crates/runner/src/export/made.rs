//! Exported data, and writing them to the disk.

use std::path::{Path, PathBuf};

use wholestring_export::Look;
use wholestring_report::Workbook;
use wholestring_results::{ResultsFolder, write_file};

use super::{
    format::{Format, What},
    text,
};
use crate::error::Error;

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
        return Ok(Made::File(text::csv(&sheet).into_bytes()));
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
