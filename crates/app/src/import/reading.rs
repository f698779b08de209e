//! What files hold, and the case that they make.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_import::{Choices, ImportError, Imported, Input, contents, import};
use wholestring_runner::import::beside;

use super::{question::Question, upload::Uploads};
use crate::workspace::{NewFile, Workspace, WorkspaceError};

/// What is said of files that they do not tell themselves.
#[derive(Debug, Default, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Said {
    /// Units by names: `md` is in `ft`.
    #[serde(default)]
    units: BTreeMap<String, String>,
    /// Values by names: `block-weight` is `25 tf`.
    #[serde(default)]
    values: BTreeMap<String, String>,
    /// Which of several is meant: the `tubular` called `BHA 7`.
    #[serde(default)]
    picks: BTreeMap<String, String>,
}

impl Said {
    fn choices(&self) -> Choices {
        let choices = Choices::default();
        let choices = self.units.iter().fold(choices, |all, (name, unit)| all.unit(name, unit));
        let choices = self.values.iter().fold(choices, |all, (name, of)| all.value(name, of));
        self.picks.iter().fold(choices, |all, (what, name)| all.pick(what, name))
    }
}

/// A file, and what it holds.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Held {
    /// What it is called.
    name: String,
    /// What it is: `a survey`, `WITSML 1.4.1.1`; null where it is none of the formats.
    what: Option<String>,
    /// What it holds, a line each; why it cannot be read, where that is so.
    lines: Vec<String>,
}

/// What is to be said of an import.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct SaidNote {
    /// The file that it is said of; null where it is said of all.
    file: Option<String>,
    /// `assumed`, `left out`, `checked` or `read`.
    kind: &'static str,
    /// A sentence.
    text: String,
}

/// The case that files make.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ImportedCase {
    /// Its text, with a comment for every value that says where it is from.
    text: String,
    /// Names of the files that stand beside it: `well-measured.csv`.
    beside: Vec<String>,
    notes: Vec<SaidNote>,
    /// What it still needs before it can be solved, in sentences.
    missing: Vec<String>,
}

/// What became of files.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Reading {
    files: Vec<Held>,
    /// What is asked before they make a case; null where nothing is.
    question: Option<Question>,
    /// Why they make none, where no answer helps.
    problem: Option<String>,
    /// The case that they make.
    case: Option<ImportedCase>,
    /// The id of the case that was written.
    written: Option<String>,
}

/// Reads files, and says what they hold and what case of that name they make; writes it, where that
/// is wanted and nothing is asked any more.
///
/// # Errors
/// A case that cannot be written: over one that is there, for one.
pub(crate) fn read(
    uploads: &Uploads,
    said: &Said,
    name: &str,
    write: bool,
    workspace: &Workspace,
) -> Result<Reading, WorkspaceError> {
    let files = uploads.0.iter().map(|upload| {
        let name = upload.name.clone();
        let found = upload
            .reader()
            .map_err(|error| error.to_string())
            .and_then(|file| contents(Input::new(&name, file)).map_err(|error| error.to_string()));
        match found {
            Ok(found) => Held { name, what: Some(found.what), lines: found.lines },
            Err(why) => Held { name, what: None, lines: vec![why] },
        }
    });
    let mut reading = Reading {
        files: files.collect(),
        question: None,
        problem: None,
        case: None,
        written: None,
    };
    let inputs = uploads.0.iter().map(|upload| Ok(Input::new(&upload.name, upload.reader()?)));
    let inputs: std::io::Result<Vec<Input<'_>>> = inputs.collect();
    match inputs.map(|inputs| import(inputs, &said.choices())) {
        Err(error) => reading.problem = Some(error.to_string()),
        Ok(Err(error)) => refuse(&mut reading, &error),
        Ok(Ok(imported)) => {
            let case = case(&imported, name);
            if write {
                reading.written = Some(put(&imported, &case, name, workspace)?);
            }
            reading.case = Some(case);
        }
    }
    Ok(reading)
}

fn refuse(reading: &mut Reading, error: &ImportError) {
    match Question::of(error) {
        Some(question) => reading.question = Some(question),
        None => reading.problem = Some(error.to_string()),
    }
}

/// The name of a case file without its ending.
fn stem(name: &str) -> &str {
    name.strip_suffix(".toml").unwrap_or(name)
}

fn case(imported: &Imported, name: &str) -> ImportedCase {
    let notes = imported.notes.iter().map(|(file, note)| SaidNote {
        file: file.clone(),
        kind: note.kind(),
        text: note.text().to_owned(),
    });
    let beside = beside(imported).into_iter().map(|(ending, _)| format!("{}{ending}", stem(name)));
    ImportedCase {
        text: imported.text_as(stem(name)),
        beside: beside.collect(),
        notes: notes.collect(),
        missing: imported.missing.clone(),
    }
}

/// Writes the case, and what stands beside it, all or nothing.
fn put(
    imported: &Imported,
    case: &ImportedCase,
    name: &str,
    workspace: &Workspace,
) -> Result<String, WorkspaceError> {
    let texts = beside(imported);
    let files = case.beside.iter().zip(&texts);
    let files: Vec<NewFile<'_>> = files.map(|(name, (_, text))| NewFile { name, text }).collect();
    workspace.create(NewFile { name, text: &case.text }, &files)
}
