//! A folder that is claimed, and held as long as it is written to.

use std::{
    path::{Path, PathBuf},
    thread,
    time::Duration,
};

use wholestring_results::{Hold, Holding, Occupant, ResultsFolder};

use super::{leftovers, refusal::FolderRefused};
use crate::{
    clock::Instant,
    error::Error,
    folder_name::default_output,
    observer::Observer,
    output::{Existing, Output},
};

/// Who claims a folder, and what for.
pub(crate) struct Claim<'a> {
    /// What will be written.
    pub(crate) occupant: Occupant,
    /// The folder that the user named, and what becomes of what lies there.
    pub(crate) output: &'a Output,
    /// Where it goes otherwise.
    pub(crate) default: PathBuf,
    /// Whether others that do a part of the same work write to the folder too.
    pub(crate) shared: bool,
    /// Who is told of another folder than the default one.
    pub(crate) observer: &'a dyn Observer,
    /// Whether the work has been begun there, and can be continued.
    pub(crate) is_unfinished: &'a dyn Fn(&Path) -> bool,
    /// Whether some of the work lies there, of more or less work than this: a sweep may be resumed
    /// with other values.
    pub(crate) is_part: &'a dyn Fn(&Path) -> bool,
    /// Why the work cannot go to a folder that could be held, if anything else is against it.
    pub(crate) refuse: &'a dyn Fn(&Path) -> Result<(), Error>,
}

/// A folder for results, and what keeps others out of it as long as it lives.
pub(crate) struct Claimed {
    pub(crate) folder: ResultsFolder,
    hold: Hold,
}

/// What comes of a folder that was looked at.
enum FolderState {
    Free(ResultsFolder, Hold),
    /// A part of the work lies there.
    Part(ResultsFolder, Hold),
    /// The same work was begun there.
    Unfinished,
    /// It holds other results.
    Other(Option<Occupant>),
    /// Another program writes to it.
    Busy(Option<Occupant>),
}

/// More folders of one name than this are a mistake.
const MAX_FOLDERS: usize = 1000;

/// How long a share waits for a folder that another share only looks at, and how often it looks
/// again: with many shares that begin at once on a busy machine each look takes long.
const PATIENCE: Duration = Duration::from_secs(60);
const PAUSE: Duration = Duration::from_millis(5);

impl<'a> Claim<'a> {
    /// A claim for work that one program does at once, in the folder that is called like it.
    pub(crate) fn new(occupant: Occupant, output: &'a Output, observer: &'a dyn Observer) -> Self {
        Self {
            default: default_output(&output.root, &occupant.name),
            occupant,
            output,
            shared: false,
            observer,
            is_unfinished: &|_| false,
            is_part: &|_| false,
            refuse: &|_| Ok(()),
        }
    }
}

impl Claim<'_> {
    /// The folder: the one that was named, or the default one; where that holds other results, the
    /// next one that does not, with a number after its name.
    ///
    /// # Errors
    /// A named folder with other results, an unfinished run of the same work, or another program
    /// that writes there.
    pub(crate) fn folder(&self) -> Result<Claimed, Error> {
        if let Some(path) = &self.output.folder {
            return match self.inspect(path)? {
                FolderState::Free(folder, hold) | FolderState::Part(folder, hold) => {
                    self.take(folder, hold)
                }
                FolderState::Unfinished => Err(self.unfinished(path)),
                FolderState::Other(there) => {
                    let path = path.clone();
                    let ours = |there: &Occupant| {
                        (&there.kind, &there.name) == (&self.occupant.kind, &self.occupant.name)
                    };
                    let alike = there.as_ref().is_some_and(ours);
                    Err(FolderRefused::Occupied { path, there, alike }.into())
                }
                FolderState::Busy(_) => Err(busy(path)),
            };
        }
        let ours = |there: &Option<Occupant>| {
            there.as_ref().is_none_or(|there| self.occupant.is_same(there))
        };
        // The same work has the first say, wherever it lies.
        let mut part = None;
        for number in 1..=MAX_FOLDERS {
            let path = numbered(&self.default, number);
            if !path.exists()
                && let Some((folder, hold)) = part.take()
            {
                return self.take(folder, hold);
            }
            match self.inspect(&path)? {
                FolderState::Part(folder, hold) => part = part.or(Some((folder, hold))),
                FolderState::Free(folder, hold) => {
                    if number > 1 {
                        self.observer.note(&format!(
                            "{} holds other results, and is left alone: these go to {}",
                            self.default.display(),
                            path.display()
                        ));
                    }
                    return self.take(folder, hold);
                }
                FolderState::Unfinished => return Err(self.unfinished(&path)),
                FolderState::Busy(there) if ours(&there) => return Err(busy(&path)),
                FolderState::Other(_) | FolderState::Busy(_) => {}
            }
        }
        Err(FolderRefused::AllOccupied { path: self.default.clone(), count: MAX_FOLDERS }.into())
    }

    fn inspect(&self, path: &Path) -> Result<FolderState, Error> {
        let folder = ResultsFolder::create(path)?;
        let since = Instant::now();
        let hold = loop {
            match folder.hold(self.shared)? {
                Holding::Alone(hold) => break hold,
                // Nobody shares what is not the same.
                Holding::Shared(hold)
                    if hold.occupant().is_some_and(|there| self.occupant.is_same(there)) =>
                {
                    break hold;
                }
                Holding::Shared(hold) => return Ok(FolderState::Busy(hold.occupant().cloned())),
                Holding::Busy(there) => {
                    let same = there.as_ref();
                    let same = same.is_none_or(|there| self.occupant.is_same(there));
                    if !(self.shared && same) || since.elapsed() > PATIENCE {
                        return Ok(FolderState::Busy(there));
                    }
                    thread::sleep(PAUSE);
                }
            }
        };
        let there =
            if folder.is_used() { leftovers::occupant(&folder, hold.occupant()) } else { None };
        Ok(match there {
            None => FolderState::Free(folder, hold),
            Some(Some(there)) if self.occupant.is_same(&there) => {
                if self.output.existing == Existing::Protect && (self.is_unfinished)(path) {
                    FolderState::Unfinished
                } else {
                    FolderState::Free(folder, hold)
                }
            }
            Some(_) if self.output.existing == Existing::Overwrite => {
                leftovers::remove(path)?;
                FolderState::Free(folder, hold)
            }
            // Which of its cases are finished is found one by one.
            Some(there)
                if self.output.existing == Existing::Resume
                    && there.as_ref().is_none_or(|one| one.kind == self.occupant.kind)
                    && (self.is_part)(path) =>
            {
                FolderState::Part(folder, hold)
            }
            Some(there) => FolderState::Other(there),
        })
    }

    fn take(&self, folder: ResultsFolder, mut hold: Hold) -> Result<Claimed, Error> {
        (self.refuse)(folder.path())?;
        hold.occupy(&self.occupant)?;
        if self.shared {
            let since = Instant::now();
            while !hold.share() {
                if since.elapsed() > PATIENCE {
                    return Err(busy(folder.path()));
                }
                thread::sleep(PAUSE);
            }
            // While nobody held the folder, other work may have taken it.
            if !hold.says().is_some_and(|there| self.occupant.is_same(&there)) {
                return Err(busy(folder.path()));
            }
        }
        self.observer.folder(folder.path());
        Ok(Claimed { folder, hold })
    }

    fn unfinished(&self, path: &Path) -> Error {
        let kind = self.occupant.kind.clone();
        let path = path.to_owned();
        FolderRefused::Unfinished { path, kind }.into()
    }
}

/// Holds a folder whose work is continued, whatever it is.
///
/// # Errors
/// Another program that writes there.
pub(crate) fn hold(folder: &ResultsFolder) -> Result<Claimed, Error> {
    match folder.hold(false)? {
        Holding::Alone(hold) => Ok(Claimed { folder: folder.clone(), hold }),
        Holding::Shared(_) | Holding::Busy(_) => Err(busy(folder.path())),
    }
}

impl Claimed {
    /// Digest of all that the results depend on.
    pub(crate) fn identity(&self) -> &str {
        self.hold.occupant().map_or("", |occupant| &occupant.identity)
    }

    /// Says what the folder is written for from now on.
    pub(crate) fn occupy(mut self, occupant: &Occupant) -> Result<Self, Error> {
        self.hold.occupy(occupant)?;
        Ok(self)
    }
}

/// `out/case`, `out/case-2`, ...
fn numbered(path: &Path, number: usize) -> PathBuf {
    if number == 1 {
        return path.to_owned();
    }
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!("-{number}"));
    path.with_file_name(name)
}

fn busy(path: &Path) -> Error {
    FolderRefused::Busy { path: path.to_owned() }.into()
}
