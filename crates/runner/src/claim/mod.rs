//! Ownership of folders: results of one case never replace those of another silently, and no two
//! programs write to one folder, except the shards of one sweep.

mod leftovers;
mod refusal;

pub(crate) use leftovers::remove as remove_results;
pub use refusal::FolderRefused;

use std::{
    path::{Path, PathBuf},
    thread,
    time::Duration,
};

use wholestring_results::{Hold, Holding, Occupant, ResultsFolder};

use crate::{
    clock::Instant,
    error::Error,
    folder_name::default_output,
    observer::Observer,
    output::{Existing, Output},
};

// A folder that is claimed, and locked while it is written to.

/// A claim of a folder for some work.
pub(crate) struct Claim<'a> {
    /// The work that will be written.
    pub(crate) occupant: Occupant,
    /// Folder given by the user, and treatment of existing files.
    pub(crate) output: &'a Output,
    /// The default folder.
    pub(crate) default: PathBuf,
    /// Whether other processes that do part of the same work also write to the folder.
    pub(crate) shared: bool,
    /// Notified if the folder is not the default one.
    pub(crate) observer: &'a dyn Observer,
    /// Whether the work was begun there and can be continued.
    pub(crate) is_unfinished: &'a dyn Fn(&Path) -> bool,
    /// Whether the folder contains part of this work, even if the amount of work differs: a sweep
    /// may be resumed with other values.
    pub(crate) is_part: &'a dyn Fn(&Path) -> bool,
    /// Folders within the folder that the work writes to.
    pub(crate) within: &'a dyn Fn(&Path) -> Vec<PathBuf>,
    /// Any other reason why the work cannot use a folder that could be locked.
    pub(crate) refuse: &'a dyn Fn(&Path) -> Result<(), Error>,
}

/// A folder for results, locked for others during its lifetime.
pub(crate) struct Claimed {
    pub(crate) folder: ResultsFolder,
    hold: Hold,
}

/// State of a folder that was inspected.
enum FolderState {
    Free(ResultsFolder, Hold),
    /// It contains part of the work.
    Part(ResultsFolder, Hold),
    /// The same work was begun there.
    Unfinished,
    /// It contains files of somebody else that the results would replace: the folder, their names.
    Foreign(PathBuf, Vec<String>),
    /// It contains other results.
    Other(Option<Occupant>),
    /// Another program writes to it.
    Busy(Option<Occupant>),
}

/// Largest number of folders with one base name; more indicate a mistake.
const MAX_FOLDERS: usize = 1000;

/// Longest wait of a share for a folder that another share only inspects, and the interval of
/// attempts: with many shares that start at once on a busy machine each inspection takes long.
const PATIENCE: Duration = Duration::from_secs(60);
const PAUSE: Duration = Duration::from_millis(5);

impl<'a> Claim<'a> {
    /// Creates a claim for unshared work, in the folder named after it.
    pub(crate) fn new(occupant: Occupant, output: &'a Output, observer: &'a dyn Observer) -> Self {
        Self {
            default: default_output(&output.root, &occupant.name),
            occupant,
            output,
            shared: false,
            observer,
            is_unfinished: &|_| false,
            is_part: &|_| false,
            within: &|_| Vec::new(),
            refuse: &|_| Ok(()),
        }
    }
}

impl Claim<'_> {
    /// Returns the folder: the given one, or the default one; if that contains other results, the
    /// next free one with a number after its name.
    ///
    /// # Errors
    /// A given folder with other results, an unfinished run of the same work, or another program
    /// that writes there.
    pub(crate) fn folder(&self) -> Result<Claimed, Error> {
        if let Some(path) = &self.output.folder {
            return match self.inspect(path)? {
                FolderState::Free(folder, hold) | FolderState::Part(folder, hold) => {
                    self.take(folder, hold)
                }
                FolderState::Unfinished => Err(self.unfinished(path)),
                FolderState::Foreign(path, names) => {
                    Err(FolderRefused::Foreign { path, names }.into())
                }
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
        // A folder with the same work takes precedence, whatever its number.
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
                            "{} holds other results and is not changed: these are written to {}",
                            self.default.display(),
                            path.display()
                        ));
                    }
                    return self.take(folder, hold);
                }
                FolderState::Unfinished => return Err(self.unfinished(&path)),
                FolderState::Busy(there) if ours(&there) => return Err(busy(&path)),
                FolderState::Foreign(..) | FolderState::Other(_) | FolderState::Busy(_) => {}
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
                // The lock is shared only between processes of the same work.
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
            None if self.output.existing != Existing::Overwrite => {
                let places = [path.to_owned()].into_iter().chain((self.within)(path));
                for place in places.filter(|place| place.is_dir()) {
                    let names = leftovers::foreign(&place)?;
                    if !names.is_empty() {
                        return Ok(FolderState::Foreign(place, names));
                    }
                }
                FolderState::Free(folder, hold)
            }
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
            // Which of its cases are finished is determined case by case.
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
            // Other work may have taken the folder while it was not locked.
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

/// Locks a folder to continue any kind of work in it.
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
    /// Digest of all inputs that the results depend on.
    pub(crate) fn identity(&self) -> &str {
        self.hold.occupant().map_or("", |occupant| &occupant.identity)
    }

    /// Records the work that the folder is written for from now on.
    pub(crate) fn occupy(mut self, occupant: &Occupant) -> Result<Self, Error> {
        self.hold.occupy(occupant)?;
        Ok(self)
    }
}

/// Numbered folder names: `out/case`, `out/case-2`, ...
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
