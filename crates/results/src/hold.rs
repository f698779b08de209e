//! A locked folder: held by one program at a time, and identified by the work that it was written
//! for.
//!
//! `.wholestring` in the folder records the work that the folder was written for. A program that
//! writes to the folder holds a lock of the system on that file; the lock ends with the program,
//! however that ends. The file remains.

use std::{
    fs::{self, File, OpenOptions, TryLockError},
    io::{self, Read, Seek, Write},
    path::{Path, PathBuf},
};

use serde::{Deserialize, Serialize};

use crate::{ResultsError, ResultsFolder};

/// Name of the file.
pub(crate) const NAME: &str = ".wholestring";

/// Work that a folder is written for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Occupant {
    /// The command: `run`, `sweep`, ...
    pub kind: String,
    /// Name of the case or of the study.
    pub name: String,
    /// Digest of everything that the results depend on.
    pub identity: String,
}

impl Occupant {
    /// Reads the work that a folder was written for; `None` where no record exists.
    pub fn of_folder(path: &Path) -> Option<Self> {
        read(&mut File::open(path.join(NAME)).ok()?)
    }

    /// Whether the other is the same work, whatever its name.
    pub fn is_same(&self, other: &Self) -> bool {
        self.kind == other.kind && self.identity == other.identity
    }
}

/// A folder that is locked until this is dropped.
#[derive(Debug)]
pub struct Hold {
    path: PathBuf,
    file: File,
    occupant: Option<Occupant>,
}

/// Result of locking a folder.
#[derive(Debug)]
pub enum Holding {
    /// This program alone writes to it.
    Alone(Hold),
    /// Others that share it also write to it.
    Shared(Hold),
    /// Another program writes to it; its work, where that can be read.
    Busy(Option<Occupant>),
}

impl ResultsFolder {
    /// Locks the folder, alone if no other program holds it; with `shared`, together with others
    /// that share it.
    ///
    /// A file system without locks excludes nobody.
    ///
    /// # Errors
    /// A file that cannot be opened.
    pub fn hold(&self, shared: bool) -> Result<Holding, ResultsError> {
        let path = self.path().join(NAME);
        let wrong = |source: io::Error| ResultsError::Write { path: path.clone(), source };
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(&path).map_err(wrong)?;
        let alone = match file.try_lock() {
            Ok(()) => true,
            Err(TryLockError::WouldBlock) if shared => match file.try_lock_shared() {
                Ok(()) => false,
                Err(_) => return Ok(Holding::Busy(read(&mut file))),
            },
            Err(TryLockError::WouldBlock) => return Ok(Holding::Busy(read(&mut file))),
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => true,
            Err(TryLockError::Error(error)) => return Err(wrong(error)),
        };
        let occupant = read(&mut file);
        let hold = Hold { path, file, occupant };
        Ok(if alone { Holding::Alone(hold) } else { Holding::Shared(hold) })
    }

    /// Whether the folder has any file except the record of its work.
    pub fn is_used(&self) -> bool {
        let entries = fs::read_dir(self.path()).into_iter().flatten();
        entries.flatten().any(|entry| entry.file_name() != NAME)
    }
}

impl Hold {
    /// Work that the folder was written for; `None` without a record.
    pub fn occupant(&self) -> Option<&Occupant> {
        self.occupant.as_ref()
    }

    /// Records the work that the folder is written for from now on.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn occupy(&mut self, occupant: &Occupant) -> Result<(), ResultsError> {
        if self.occupant.as_ref() == Some(occupant) {
            return Ok(());
        }
        let write = |mut file: &File| {
            let text = serde_json::to_vec(occupant)?;
            file.set_len(0)?;
            file.rewind()?;
            file.write_all(&text)?;
            file.sync_all()
        };
        write(&self.file)
            .map_err(|source| ResultsError::Write { path: self.path.clone(), source })?;
        self.occupant = Some(occupant.clone());
        Ok(())
    }

    /// Reads the work that the folder is written for from its file again.
    pub fn says(&mut self) -> Option<Occupant> {
        read(&mut self.file)
    }

    /// Lets others share the folder. Returns false where another program locked it alone in
    /// between.
    pub fn share(&self) -> bool {
        // Not every system converts a lock atomically.
        let _ = self.file.unlock();
        match self.file.try_lock_shared() {
            Ok(()) => true,
            Err(TryLockError::WouldBlock) => false,
            Err(TryLockError::Error(error)) => error.kind() == io::ErrorKind::Unsupported,
        }
    }
}

/// Reads the record of the file; `None` where it is empty, or where a lock prevents reading.
fn read(file: &mut File) -> Option<Occupant> {
    /// A longer file is not a record.
    const MAX_BYTES: u64 = 1 << 16;
    let mut text = Vec::new();
    file.rewind().ok()?;
    file.take(MAX_BYTES).read_to_end(&mut text).ok()?;
    serde_json::from_slice(&text).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn occupant(identity: &str) -> Occupant {
        Occupant { kind: "run".into(), name: "a well".into(), identity: identity.into() }
    }

    fn folder() -> (tempfile::TempDir, ResultsFolder) {
        let place = tempfile::tempdir().unwrap();
        let folder = ResultsFolder::create(place.path()).unwrap();
        (place, folder)
    }

    fn alone(folder: &ResultsFolder) -> Hold {
        match folder.hold(false).unwrap() {
            Holding::Alone(hold) => hold,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_second_is_kept_out_until_the_first_is_done() {
        let (_place, folder) = folder();
        let mut first = alone(&folder);
        assert_eq!(first.occupant(), None);
        first.occupy(&occupant("1")).unwrap();
        assert!(matches!(folder.hold(false).unwrap(), Holding::Busy(_)));
        assert!(matches!(folder.hold(true).unwrap(), Holding::Busy(_)));
        drop(first);
        let mut second = alone(&folder);
        assert_eq!(second.occupant(), Some(&occupant("1")));
        second.occupy(&occupant("a longer one")).unwrap();
        second.occupy(&occupant("2")).unwrap();
        drop(second);
        assert_eq!(alone(&folder).occupant(), Some(&occupant("2")));
    }

    #[test]
    fn those_that_share_are_let_in_and_others_are_not() {
        let (_place, folder) = folder();
        let mut first = alone(&folder);
        first.occupy(&occupant("1")).unwrap();
        assert!(first.share());
        let second = match folder.hold(true).unwrap() {
            Holding::Shared(hold) => hold,
            other => panic!("{other:?}"),
        };
        assert_eq!(second.occupant(), Some(&occupant("1")));
        assert!(matches!(folder.hold(false).unwrap(), Holding::Busy(_)));
        drop(first);
        assert!(matches!(folder.hold(false).unwrap(), Holding::Busy(_)));
        drop(second);
        alone(&folder);
    }

    #[test]
    fn what_says_whose_a_folder_is_does_not_fill_it() {
        let (_place, folder) = folder();
        alone(&folder).occupy(&occupant("1")).unwrap();
        assert!(!folder.is_used());
        folder.write_file("a.txt", b"").unwrap();
        assert!(folder.is_used());
    }
}
