//! A case file that is read once and makes many cases.

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
};

use crate::{
    build::{parse, parse_changed},
    case::Case,
    edited::edited,
    overrides::Override,
    uncertain::Uncertain,
};

/// Reads the case at `path`, and the survey that it names.
///
/// # Errors
/// A report of every mistake that was found, if there is one.
pub fn load(path: &Path, changes: &[Override]) -> Result<Case, Report> {
    Template::read(path)?.case(changes)
}

/// A case file and the files that it names, read once: what becomes of them on the disk while a
/// sweep runs does not change its later cases.
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
    /// A report that says why it cannot be read.
    pub fn read(path: &Path) -> Result<Self, Report> {
        let (name, text) = read_file(path, "case")?;
        let files = Remembered { disk: Some(Box::new(Disk::beside(path))), read: Mutex::default() };
        Ok(Self { name, text, files })
    }

    /// Reads the case that comes through a pipe; the files that it names are sought from the folder
    /// that the program was begun in.
    ///
    /// # Errors
    /// A report that says why it cannot be read.
    pub fn read_pipe(path: &Path) -> Result<Self, Report> {
        let (name, text) = read_pipe(path, "case")?;
        let files = Remembered { disk: Some(Box::new(Disk::new(""))), read: Mutex::default() };
        Ok(Self { name, text, files })
    }

    /// The text, as it was read.
    pub fn bytes(&self) -> &[u8] {
        &self.text
    }

    /// A case from its text and the files that it names, each by the name that it has there;
    /// `name` is what diagnostics call it. Nothing is read from the disk.
    pub fn in_memory(name: &str, text: &str, files: BTreeMap<String, Vec<u8>>) -> Self {
        let files = Remembered { disk: None, read: Mutex::new(files) };
        Self { name: name.to_owned(), text: text.as_bytes().to_owned(), files }
    }

    /// A case from its text; the files that it names are read when they are first asked for, and
    /// then kept. `name` is what diagnostics call it.
    pub fn with_files(name: &str, text: &str, files: impl Files + Send + Sync + 'static) -> Self {
        let files = Remembered { disk: Some(Box::new(files)), read: Mutex::default() };
        Self { name: name.to_owned(), text: text.as_bytes().to_owned(), files }
    }

    /// The case with these changes.
    ///
    /// # Errors
    /// A report of every mistake that was found, if there is one.
    pub fn case(&self, changes: &[Override]) -> Result<Case, Report> {
        parse(&self.name, &self.text, &self.files, changes)
    }

    /// The case with these changes and a value of each uncertain input of its plan.
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

    /// The text of the case with these changes: see [`edited`].
    ///
    /// # Errors
    /// A text that is no TOML, and a change of a key that cannot be.
    pub fn text(&self, changes: &[Override]) -> Result<String, Report> {
        edited(&self.name, &String::from_utf8_lossy(&self.text), changes)
    }

    /// What diagnostics call it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The files that cases were made of until now, each by the name that the case has for it.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        self.files.held().clone()
    }
}

/// Files that are read when they are first requested.
struct Remembered {
    /// Nothing where all that there is was given.
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
        // A thread that panicked with it left whole files all the same.
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
