//! Cases from the files of other programs.

use std::{
    fs::File,
    io,
    path::{Path, PathBuf},
};

pub use wholestring_import::{Choices, Contents, Imported, Note};
use wholestring_import::{ImportError, ImportErrorKind, Input};
use wholestring_report::picks_html;
use wholestring_results::{ResultsError, write_new_files};

use crate::{error::Error, survey::explained};

/// Creates a case from files of other programs.
///
/// # Errors
/// A file that cannot be read, has an unknown format, or lacks data that a case requires.
pub fn read(files: &[PathBuf], choices: &Choices) -> Result<Imported, Error> {
    let inputs = files.iter().map(|file| open(file)).collect::<Result<Vec<Input>, Error>>()?;
    wholestring_import::import(inputs, choices).map_err(refusal)
}

/// Returns the format and the contents of a file.
///
/// # Errors
/// As [`read`].
pub fn contents(file: &Path) -> Result<Contents, Error> {
    wholestring_import::contents(open(file)?).map_err(refusal)
}

/// Returns the format and the contents of a file in memory; `name` identifies it in messages.
///
/// # Errors
/// As [`read`].
pub fn contents_of(name: &str, bytes: &[u8]) -> Result<Contents, Error> {
    wholestring_import::contents(Input::of_bytes(name, bytes)).map_err(refusal)
}

/// Writes a case and its accompanying files. Existing files are not overwritten.
///
/// # Errors
/// A file that exists already, or cannot be written.
pub fn write(imported: &Imported, case: &Path) -> Result<Vec<PathBuf>, Error> {
    let stem = case.file_stem().unwrap_or_default().to_string_lossy();
    let text = imported.text_as(&stem);
    let beside = beside(imported).into_iter().map(|(ending, text)| (sibling(case, &ending), text));
    let case = std::iter::once((case.to_owned(), text));
    let all: Vec<(PathBuf, String)> = case.chain(beside).collect();
    let files: Vec<(PathBuf, &[u8])> =
        all.iter().map(|(path, text)| (path.clone(), text.as_bytes())).collect();
    write_new_files(&files).map_err(|(path, error)| not_written(&path, error))?;
    Ok(all.into_iter().map(|(path, _)| path).collect())
}

/// Accompanying files of a case, by the endings that follow the case's name: readings, and a page
/// for each log from which weights were picked, which shows the windows.
pub fn beside(imported: &Imported) -> Vec<(String, String)> {
    let files = imported.beside.iter().map(|file| (file.ending.to_owned(), file.text.clone()));
    let page = |(index, picks)| {
        let ending = match index {
            0 => "-picks.html".to_owned(),
            index => format!("-picks-{}.html", index + 1),
        };
        (ending, picks_html(picks, imported.units))
    };
    files.chain(imported.picks.iter().enumerate().map(page)).collect()
}

/// `well-measured.csv` next to `well.toml`.
fn sibling(case: &Path, ending: &str) -> PathBuf {
    let mut name = case.file_stem().unwrap_or_default().to_owned();
    name.push(ending);
    case.with_file_name(name)
}

fn open(file: &Path) -> Result<Input<'static>, Error> {
    let opened = File::open(file).and_then(|opened| match opened.metadata()?.is_dir() {
        true => Err(io::Error::other("it is a folder")),
        false => Ok(opened),
    });
    let opened = opened.map_err(|error| {
        let reason = match error.kind() {
            io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        };
        Error::BadInput(format!("{} cannot be read: {reason}", file.display()))
    })?;
    Ok(Input::new(file.display().to_string(), opened))
}

/// A refusal, with the position underlined if possible.
fn refusal(error: ImportError) -> Error {
    match error.kind() {
        ImportErrorKind::Table(table) => explained(table),
        _ => Error::BadInput(error.to_string()),
    }
}

fn not_written(path: &Path, error: io::Error) -> Error {
    let path_text = path.display();
    match error.kind() {
        io::ErrorKind::AlreadyExists => Error::BadInput(format!("{path_text} is there already")),
        io::ErrorKind::NotFound => {
            Error::BadInput(format!("cannot write {path_text}: there is no such folder"))
        }
        _ => ResultsError::Write { path: path.to_owned(), source: error }.into(),
    }
}
