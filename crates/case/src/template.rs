//! A case file that is read once and makes many cases.

use std::{
    collections::BTreeMap,
    io,
    path::Path,
    sync::{Mutex, PoisonError},
};

use wholestring_config::{
    diagnostic::Report,
    file::read_file,
    source::{Disk, Files},
};

use crate::{
    build::{parse, parse_changed},
    case::Case,
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
        let files = Remembered { disk: Disk::beside(path), read: Mutex::default() };
        Ok(Self { name, text, files })
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
}

/// Files that are read from the disk when they are first requested.
#[derive(Debug)]
struct Remembered {
    disk: Disk,
    read: Mutex<BTreeMap<String, Vec<u8>>>,
}

impl Files for Remembered {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        // A thread that panicked with it left whole files all the same.
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(bytes) = read.get(path) {
            return Ok(bytes.clone());
        }
        let bytes = self.disk.read(path)?;
        read.insert(path.to_owned(), bytes.clone());
        Ok(bytes)
    }
}
