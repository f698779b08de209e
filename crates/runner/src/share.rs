//! Files of one share of a batch in the folder that it shares with others.
//!
//! Shares write the folders of their own cases concurrently. The tables and the page contain all
//! cases, so one share at a time writes them, at its end, from the results of all shares.

use std::{
    collections::BTreeMap,
    fs::{self, File, OpenOptions, TryLockError},
    io,
    path::{Path, PathBuf},
};

use serde::{Deserialize, Serialize};
use wholestring_results::{ENGINE_VERSION, ResultsError, write_file};

use crate::{
    claim::{Claimed, FolderRefused},
    error::Error,
    shard::{SHARES, Shard},
};

/// Lock file of the share that writes tables and page.
const GATHERING: &str = "gathering.lock";

/// A share of a batch in its folder. During its lifetime no other run solves it, or a share that
/// overlaps with it.
pub(crate) struct Share {
    shard: Shard,
    folder: PathBuf,
    identity: String,
    _lock: Option<File>,
}

/// Exclusive right to write the tables and the page of a batch, for the lifetime of the value.
pub(crate) struct Gathering {
    _lock: Option<File>,
}

/// Cases without results in their own folders, in the file that a share writes for the others.
#[derive(Serialize, Deserialize)]
struct Left {
    identity: String,
    engine_version: String,
    /// Reasons of the cases that failed, by name.
    failed: BTreeMap<String, String>,
}

impl Share {
    /// Starts a share in the folder claimed for the batch. A share of all cases is the whole batch,
    /// and the files of earlier shares are removed.
    ///
    /// # Errors
    /// Another run that solves the same cases there, or a file that cannot be written.
    pub(crate) fn begin(claimed: &Claimed, shard: Shard) -> Result<Self, Error> {
        let place = &claimed.folder;
        let folder = place.path().join(SHARES);
        let identity = claimed.identity().to_owned();
        if !shard.is_part() {
            if folder.is_dir() {
                fs::remove_dir_all(&folder)
                    .map_err(|source| ResultsError::Write { path: folder.clone(), source })?;
            }
            return Ok(Self { shard, folder, identity, _lock: None });
        }
        fs::create_dir_all(&folder)
            .map_err(|source| ResultsError::Folder { path: folder.clone(), source })?;
        let mut share = Self { shard, folder, identity, _lock: None };
        let own = share.file(shard, "lock");
        let busy = |share: String| {
            FolderRefused::ShareBusy { path: place.path().to_owned(), share }.into()
        };
        let Some(lock) = locked(&own)? else {
            return Err(busy(shard.to_string()));
        };
        share._lock = lock;
        match share.other_number()? {
            Some(other) => Err(busy(other)),
            None => Ok(share),
        }
    }

    /// A share of a different division that is being solved.
    fn other_number(&self) -> Result<Option<String>, ResultsError> {
        let entries = fs::read_dir(&self.folder)
            .map_err(|source| ResultsError::Read { path: self.folder.clone(), source })?;
        for entry in entries.flatten() {
            let name = entry.file_name();
            let Some(share) = name.to_str().and_then(|name| name.strip_suffix(".lock")) else {
                continue;
            };
            let other = share.replace("-of-", "/").parse::<Shard>().ok();
            if let Some(other) = other.filter(|other| other.count() != self.shard.count())
                && locked(&entry.path())?.is_none()
            {
                return Ok(Some(other.to_string()));
            }
        }
        Ok(None)
    }

    /// Whether other shares contain the remaining cases.
    pub(crate) fn is_part(&self) -> bool {
        self.shard.is_part()
    }

    /// Whether it contains the case of that index, counted from zero.
    pub(crate) fn has(&self, case: usize) -> bool {
        self.shard.has(case)
    }

    /// Writes the reasons of failed cases for the other shares, then waits until no other share
    /// writes the tables.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(crate) fn gather(
        &self,
        failed: BTreeMap<String, String>,
    ) -> Result<Gathering, ResultsError> {
        if !self.is_part() {
            return Ok(Gathering { _lock: None });
        }
        let left = Left {
            identity: self.identity.clone(),
            engine_version: ENGINE_VERSION.to_owned(),
            failed,
        };
        let path = self.file(self.shard, "json");
        let text = serde_json::to_vec(&left)
            .map_err(|error| ResultsError::Write { path: path.clone(), source: error.into() })?;
        write_file(&path, &text)?;
        let path = self.folder.join(GATHERING);
        let lock = opened(&path)?;
        let lock = match lock.lock() {
            Ok(()) => Some(lock),
            // Without file locks in the file system there is no wait.
            Err(error) if error.kind() == io::ErrorKind::Unsupported => None,
            Err(source) => return Err(ResultsError::Write { path, source }),
        };
        Ok(Gathering { _lock: lock })
    }

    /// Reasons of failed cases of the other shares, by name, for shares that have ended.
    pub(crate) fn failed_of_others(&self) -> BTreeMap<String, String> {
        let others = self.shard.siblings().filter(|other| *other != self.shard);
        let left = others.filter_map(|other| {
            let text = fs::read(self.file(other, "json")).ok()?;
            let left: Left = serde_json::from_slice(&text).ok()?;
            let ours = left.identity == self.identity && left.engine_version == ENGINE_VERSION;
            ours.then_some(left.failed)
        });
        left.flatten().collect()
    }

    /// File of a share, such as `2-of-4.json`.
    fn file(&self, shard: Shard, ending: &str) -> PathBuf {
        let name = shard.to_string().replace('/', "-of-");
        self.folder.join(format!("{name}.{ending}"))
    }
}

fn opened(path: &Path) -> Result<File, ResultsError> {
    let mut options = OpenOptions::new();
    let options = options.read(true).write(true).create(true).truncate(false);
    options.open(path).map_err(|source| ResultsError::Write { path: path.to_owned(), source })
}

/// Locks the file; `Some(None)` if the file system has no locks, `None` if another program holds
/// the lock.
fn locked(path: &Path) -> Result<Option<Option<File>>, ResultsError> {
    let file = opened(path)?;
    match file.try_lock() {
        Ok(()) => Ok(Some(Some(file))),
        Err(TryLockError::WouldBlock) => Ok(None),
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
            Ok(Some(None))
        }
        Err(TryLockError::Error(source)) => {
            Err(ResultsError::Write { path: path.to_owned(), source })
        }
    }
}
