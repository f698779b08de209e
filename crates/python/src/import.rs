//! Cases from the files of other programs.

use std::{collections::BTreeMap, path::PathBuf};

use pyo3::prelude::*;
use wholestring_runner::{
    Error,
    import::{self, Choices},
};

use crate::error;

/// Result of importing files.
#[pyclass(frozen, get_all, module = "wholestring._core")]
pub(crate) struct Imported {
    /// The case file, as `case.toml`.
    text: String,
    /// Additional files, by name.
    beside: BTreeMap<String, Vec<u8>>,
    /// Name and format of each file.
    files: Vec<(String, String)>,
    /// The file of a note, its kind and its sentence.
    notes: Vec<(Option<String>, &'static str, String)>,
    /// Missing inputs of the case.
    missing: Vec<String>,
}

/// Makes one case of some files.
#[pyfunction]
pub(crate) fn import_files(
    py: Python<'_>,
    files: Vec<PathBuf>,
    name: &str,
    units: BTreeMap<String, String>,
    values: BTreeMap<String, String>,
    picks: BTreeMap<String, String>,
) -> PyResult<Imported> {
    let choices =
        units.into_iter().fold(Choices::default(), |all, (name, unit)| all.unit(name, unit));
    let choices = values.into_iter().fold(choices, |all, (name, value)| all.value(name, value));
    let choices = picks.into_iter().fold(choices, |all, (what, name)| all.pick(what, name));
    // Choices are marked as used, by one thread.
    let imported = import::read(&files, &choices);
    let imported = imported.map_err(|refused| refusal(py, refused))?;
    let beside = imported.beside.iter();
    Ok(Imported {
        text: imported.text_as(name),
        beside: beside
            .map(|file| (format!("{name}{}", file.ending), file.text.clone().into_bytes()))
            .collect(),
        notes: imported
            .notes
            .into_iter()
            .map(|(file, note)| (file, note.kind(), note.text().to_owned()))
            .collect(),
        files: imported.files,
        missing: imported.missing,
    })
}

/// Format and contents of a file.
#[pyfunction]
pub(crate) fn contents(py: Python<'_>, file: PathBuf) -> PyResult<(String, Vec<String>)> {
    let found = py.detach(|| import::contents(&file));
    let found = found.map_err(|refused| refusal(py, refused))?;
    let errors = found.errors.iter().map(|error| format!("error: {error}"));
    Ok((found.what, found.lines.iter().cloned().chain(errors).collect()))
}

/// A refusal of a file: no mistake of a case, although it is shown as one, underlined.
fn refusal(py: Python<'_>, refused: Error) -> PyErr {
    match refused {
        Error::Unsound(_) => error::of_work(py, &Error::BadInput(refused.to_string())),
        other => error::of_work(py, &other),
    }
}
