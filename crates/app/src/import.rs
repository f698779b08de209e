//! Files of other programs that are dropped on the page, and the case that they make.

use std::{
    collections::BTreeMap,
    fs::File,
    io::{self, Seek, Write},
};

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_import::{
    Choices, ImportError, ImportErrorKind, Imported, Input, contents, import,
};
use wholestring_runner::import::beside;
use wholestring_units::Dimension;

use crate::workspace::{NewFile, Workspace, WorkspaceError};

// Contents of files, and the case that they make.

/// Information that is missing in the files.
#[derive(Debug, Default, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Said {
    /// Units by name: `md` is in `ft`.
    #[serde(default)]
    units: BTreeMap<String, String>,
    /// Values by name: `block-weight` is `25 tf`.
    #[serde(default)]
    values: BTreeMap<String, String>,
    /// Choices by name: the `tubular` called `BHA 7`.
    #[serde(default)]
    picks: BTreeMap<String, String>,
}

impl Said {
    fn choices(&self) -> Choices {
        let choices = Choices::default();
        let choices = self.units.iter().fold(choices, |all, (name, unit)| all.unit(name, unit));
        let choices = self.values.iter().fold(choices, |all, (name, value)| all.value(name, value));
        self.picks.iter().fold(choices, |all, (what, name)| all.pick(what, name))
    }
}

/// A file and its contents.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Held {
    /// Its name.
    name: String,
    /// Its format: `a survey`, `WITSML 1.4.1.1`; null if it is none of the known ones.
    what: Option<String>,
    /// Its contents, one line each, or the reason why it cannot be read.
    lines: Vec<String>,
}

/// A note about an import.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct SaidNote {
    /// The file of the note; null for all files.
    file: Option<String>,
    /// `assumed`, `left out`, `checked` or `read`.
    kind: &'static str,
    /// A sentence.
    text: String,
}

/// The case that files make.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ImportedCase {
    /// Its text, with a comment on the source of every value.
    text: String,
    /// Names of the files that accompany it: `well-measured.csv`.
    beside: Vec<String>,
    notes: Vec<SaidNote>,
    /// Missing inputs without which it cannot be solved, in sentences.
    missing: Vec<String>,
}

/// Result of reading files.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Reading {
    files: Vec<Held>,
    /// The question to answer before they make a case; null if there is none.
    question: Option<Question>,
    /// Reason why they make no case, if no answer helps.
    problem: Option<String>,
    /// The case that they make.
    case: Option<ImportedCase>,
    /// The id of the case that was written.
    written: Option<String>,
}

/// Reads files, and returns their contents and the case with that name that they make; writes the
/// case if requested and if no question is open.
///
/// # Errors
/// A case that cannot be written, for example because it exists.
pub(crate) fn read(
    uploads: &Uploads,
    choices: &Said,
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
            Ok(found) => {
                let errors = found.errors.iter().map(|error| format!("error: {error}"));
                let lines = found.lines.iter().cloned().chain(errors).collect();
                Held { name, what: Some(found.what), lines }
            }
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
    match inputs.map(|inputs| import(inputs, &choices.choices())) {
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

/// The name of a case file without its extension.
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

/// Writes the case and its accompanying files, all or nothing.
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

// Questions about missing information, answered as by `--unit`, `--value` and `--pick`.

/// An option that answers a question: `--unit`, `--value` or `--pick`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Ask {
    /// A unit.
    Unit,
    /// A value.
    Value,
    /// One of several.
    Pick,
}

/// A choice that is missing or invalid.
#[derive(Debug, PartialEq, Serialize, ToSchema)]
pub(crate) struct Question {
    /// The option that answers it.
    ask: Ask,
    /// The name under which it is answered: `md`, `block-weight`, `tubular`.
    name: String,
    /// Possible answers; for a value, examples of its notation.
    options: Vec<String>,
    /// The question as a sentence, with the file and the place in it.
    message: String,
}

fn units(dimension: Dimension) -> Vec<String> {
    dimension.units().iter().map(|unit| unit.symbol.to_owned()).collect()
}

impl Question {
    /// The question of an import error; none if no choice helps.
    fn of(error: &ImportError) -> Option<Self> {
        let (ask, name, options) = match error.kind() {
            ImportErrorKind::MissingUnit { name, dimension, .. }
            | ImportErrorKind::SaidUnit { name, dimension, .. } => {
                (Ask::Unit, name.clone(), units(*dimension))
            }
            ImportErrorKind::MissingValue { name, example, .. } => {
                (Ask::Value, name.clone(), vec![example.clone()])
            }
            ImportErrorKind::SaidValue { name, .. } => (Ask::Value, name.clone(), Vec::new()),
            ImportErrorKind::Ambiguous { what, names }
            | ImportErrorKind::NoSuch { what, names, .. } => {
                (Ask::Pick, what.clone(), names.clone())
            }
            ImportErrorKind::InTwoFiles { what, first } => {
                let files = vec![first.clone(), error.file().to_owned()];
                (Ask::Pick, (*what).to_owned(), files)
            }
            _ => return None,
        };
        Some(Self { ask, name, options, message: message(error) })
    }
}

/// The message without options of the command line.
fn message(error: &ImportError) -> String {
    let sentence = match error.kind() {
        ImportErrorKind::MissingUnit { what, .. } => format!("the {what} has no unit"),
        ImportErrorKind::MissingValue { what, hint, .. } => {
            format!("the {what} is missing{hint}")
        }
        ImportErrorKind::SaidUnit { said, dimension, .. } => {
            format!("'{said}' is no unit of {}", dimension.name())
        }
        ImportErrorKind::SaidValue { said, reason, .. } => format!("'{said}': {reason}"),
        ImportErrorKind::Ambiguous { what, names } => {
            format!("it holds {} of the kind '{what}'", names.len())
        }
        ImportErrorKind::InTwoFiles { what, first } => {
            format!("it holds the {what}, and so does {first}")
        }
        kind => kind.to_string(),
    };
    let place = error.place().map_or_else(String::new, |place| format!(", {place}"));
    format!("{}{place}: {sentence}", error.file())
}

// Uploads: stored on disk, not in memory, and deleted after reading.

/// Maximum number of files of one import.
const MOST: usize = 40;

/// Maximum length of names shown.
const LONGEST_NAME: usize = 120;

/// An uploaded file.
#[derive(Debug)]
pub(crate) struct Upload {
    /// Its name, without a path.
    name: String,
    file: File,
}

impl Upload {
    /// A new reader from its beginning.
    fn reader(&self) -> io::Result<File> {
        let mut reader = self.file.try_clone()?;
        reader.rewind()?;
        Ok(reader)
    }

    /// Appends received bytes.
    ///
    /// # Errors
    /// A full disk.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.write_all(bytes)
    }
}

/// Files of one import.
#[derive(Debug, Default)]
pub(crate) struct Uploads(Vec<Upload>);

impl Uploads {
    /// Begins a file with this name.
    ///
    /// # Errors
    /// Too many files, or two of one name.
    pub(crate) fn begin(&mut self, name: &str, file: File) -> Result<&mut Upload, String> {
        if self.0.len() == MOST {
            return Err(format!("more than {MOST} files are not imported at once"));
        }
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        let name: String =
            name.chars().filter(|letter| !letter.is_control()).take(LONGEST_NAME).collect();
        if name.is_empty() {
            return Err("a file has no name".to_owned());
        }
        if let Some(letter) = wholestring_case::invisible(&name) {
            let (name, character) = (name.escape_debug(), wholestring_case::described(letter));
            return Err(format!("the name of the file `{name}` contains {character}; rename it"));
        }
        if self.0.iter().any(|upload| upload.name == name) {
            return Err(format!("two files are called `{name}`"));
        }
        self.0.push(Upload { name, file });
        let last = self.0.len() - 1;
        Ok(&mut self.0[last])
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}
