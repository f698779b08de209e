//! A case file that is read once for many cases.

use std::{
    collections::BTreeMap,
    fmt, io,
    path::Path,
    sync::{Mutex, MutexGuard, PoisonError},
};

use wholestring_config::{
    diagnostic::Report,
    file::{read_file, read_pipe},
    source::{Disk, Files},
    table::Keys as _,
};

use crate::{
    case::{
        Case,
        build::{parse, parse_changed},
        table::CaseTable,
    },
    edit::{edited::edited, overrides::Override},
    uncertain::Uncertain,
};

/// Reads the case at `path`, and the survey that it names.
///
/// # Errors
/// A report of every mistake that was found, if there is one.
pub fn load(path: &Path, changes: &[Override]) -> Result<Case, Report> {
    Template::read(path)?.case(changes)
}

/// A case file and the files that it names, read once, so that changes on the disk during a sweep
/// do not affect its later cases.
#[derive(Debug)]
pub struct Template {
    name: String,
    text: Vec<u8>,
    files: Remembered,
}

impl Template {
    /// Reads the case file at `path`.
    ///
    /// # Errors
    /// A report of the reason why it cannot be read.
    pub fn read(path: &Path) -> Result<Self, Report> {
        let (name, text) = read_file(path, "case")?;
        let files = Remembered { disk: Some(Box::new(Disk::beside(path))), read: Mutex::default() };
        Ok(Self { name, text, files })
    }

    /// Reads a case from a pipe; the files that it names are looked up relative to the working
    /// directory of the program.
    ///
    /// # Errors
    /// A report of the reason why it cannot be read.
    pub fn read_pipe(path: &Path) -> Result<Self, Report> {
        let (name, text) = read_pipe(path, "case")?;
        let files = Remembered { disk: Some(Box::new(Disk::new(""))), read: Mutex::default() };
        Ok(Self { name, text, files })
    }

    /// Returns the text as read.
    pub fn bytes(&self) -> &[u8] {
        &self.text
    }

    /// Returns a case from its text and the files that it names, each by its name in the text;
    /// `name` is the name in diagnostics. Nothing is read from the disk.
    pub fn in_memory(name: &str, text: &str, files: BTreeMap<String, Vec<u8>>) -> Self {
        let files = Remembered { disk: None, read: Mutex::new(files) };
        Self { name: name.to_owned(), text: text.as_bytes().to_owned(), files }
    }

    /// Returns a case from its text; the files that it names are read on first use, and then
    /// cached. `name` is the name in diagnostics.
    pub fn with_files(name: &str, text: &str, files: impl Files + Send + Sync + 'static) -> Self {
        let files = Remembered { disk: Some(Box::new(files)), read: Mutex::default() };
        Self { name: name.to_owned(), text: text.as_bytes().to_owned(), files }
    }

    /// Returns the case with these changes.
    ///
    /// # Errors
    /// A report of every mistake that was found, if there is one.
    pub fn case(&self, changes: &[Override]) -> Result<Case, Report> {
        parse(&self.name, &self.text, &self.files, changes)
    }

    /// Returns the case with these changes and a value of each uncertain input of its plan.
    ///
    /// # Errors
    /// A report of every mistake that was found, if there is one.
    pub fn sample(
        &self,
        changes: &[Override],
        uncertain: &Uncertain,
        point: &[f64],
    ) -> Result<Case, Report> {
        let change = |root: &mut _, reader: &mut _| uncertain.put(point, root, reader);
        parse_changed(&self.name, &self.text, &self.files, changes, change)
    }

    /// Returns the text of the case with these changes: see [`edited`].
    ///
    /// # Errors
    /// A text that is not TOML, and a change of a key that is not possible.
    pub fn text(&self, changes: &[Override]) -> Result<String, Report> {
        edited(&self.name, &String::from_utf8_lossy(&self.text), changes)
    }

    /// Returns its name in diagnostics.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the files that have been used in cases so far, each by its name in the case.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        self.files.held().clone()
    }
}

/// Files that are read when they are first requested.
struct Remembered {
    /// `None` where all files were given.
    disk: Option<Box<dyn Files + Send + Sync>>,
    read: Mutex<BTreeMap<String, Vec<u8>>>,
}

impl fmt::Debug for Remembered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.held().keys()).finish()
    }
}

impl Remembered {
    fn held(&self) -> MutexGuard<'_, BTreeMap<String, Vec<u8>>> {
        // A thread that panicked while it held the lock left only whole files.
        self.read.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Files for Remembered {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        let mut read = self.held();
        if let Some(bytes) = read.get(path) {
            return Ok(bytes.clone());
        }
        let Some(disk) = &self.disk else {
            return Err(io::Error::new(io::ErrorKind::NotFound, "there is no such file"));
        };
        let bytes = disk.read(path)?;
        read.insert(path.to_owned(), bytes.clone());
        Ok(bytes)
    }
}

// A starting case.

/// The case. Its name is filled in.
const TEMPLATE: &str = include_str!("new_case.toml");

/// The placeholder of the name.
const NAME: &str = "\"My well\"";

/// Returns the text of a commented starting case with the name `name`.
pub fn new_case(name: &str) -> String {
    let name = name.replace('\\', "\\\\").replace('"', "\\\"");
    TEMPLATE.replacen(NAME, &format!("\"{name}\""), 1)
}

// Whether a text is intended as a case file, valid or not.

/// Whether a text is intended as a case file, by the names of its tables and of its keys above the
/// first one; neither its mistakes nor the name of its file matter.
///
/// ```
/// use wholestring_case::is_case;
///
/// assert!(is_case("# a well\n[well]\nstations = [oops"));
/// assert!(!is_case("MD (m),Inc (deg),Azi (deg)\n0,0,0\n30,1,45\n"));
/// ```
pub fn is_case(text: &str) -> bool {
    let names = CaseTable::names();
    let is_key = |word: &str| names.contains(&word.trim().trim_matches(['"', '\'']));
    let mut above = true;
    text.trim_start_matches('\u{feff}').lines().map(str::trim_start).any(|line| {
        if let Some(header) = line.strip_prefix('[') {
            above = false;
            let header = header.trim_start_matches('[');
            let name = header.split(['.', ']']).next().unwrap_or_default();
            return header.contains(']') && is_key(name);
        }
        let is_value = |value: &str| value.trim_start().starts_with(['"', '\'', '[', '{']);
        above && line.split_once('=').is_some_and(|(key, value)| is_key(key) && is_value(value))
    })
}
