//! How work has ended, in words.

use std::path::{Path, PathBuf};

use wholestring_runner::{BatchOutcome, Error, FolderRefused};

use super::job::{Refusal, State};

/// How work has ended.
#[derive(Debug)]
pub(super) struct Ended {
    /// Where the results are, where there are some.
    pub(super) folder: Option<PathBuf>,
    pub(super) state: State,
    pub(super) message: Option<String>,
    pub(super) refusal: Option<Refusal>,
}

impl Ended {
    /// It has come to its end.
    pub(super) fn finished(folder: PathBuf, message: Option<String>) -> Self {
        Self { folder: Some(folder), state: State::Finished, message, refusal: None }
    }

    /// It was stopped; `is_resumable` says whether it can go on from there.
    pub(super) fn stopped(folder: PathBuf) -> Self {
        let message = Some("stopped: what was computed is kept".to_owned());
        Self { folder: Some(folder), state: State::Stopped, message, refusal: None }
    }

    /// It has no whole answer.
    pub(super) fn failed(folder: PathBuf, message: String) -> Self {
        Self { folder: Some(folder), state: State::Failed, message: Some(message), refusal: None }
    }

    /// Many cases or points, called `items`.
    pub(super) fn batch(outcome: &BatchOutcome, items: &str) -> Self {
        let folder = outcome.folder.clone();
        let (all, finished) = (outcome.all, outcome.finished);
        let failed = outcome.failed.iter();
        let failed: Vec<String> = failed.map(|of| format!("{}: {}", of.name, of.reason)).collect();
        let count = format!("{finished} of {all} {items} finished");
        if outcome.is_interrupted() {
            let lines = [vec![format!("stopped: {count}; they are kept")], failed].concat();
            return Self { message: Some(lines.join("\n")), ..Self::stopped(folder) };
        }
        if !failed.is_empty() {
            let head = format!("{} of {all} {items} failed", failed.len());
            return Self::failed(folder, [vec![head], failed].concat().join("\n"));
        }
        let wrong = outcome.with_errors.iter();
        let wrong: Vec<String> = wrong
            .map(|of| format!("errors were found in {}: {}", of.name, of.operations.join(", ")))
            .collect();
        Self::finished(folder, Some([vec![count], wrong].concat().join("\n")))
    }

    /// It was not begun, or not brought to its end. Paths are shown as seen from the folder.
    pub(super) fn of_error(error: &Error, root: &Path) -> Self {
        let (state, refusal) = match error {
            Error::Unsound(_) | Error::BadInput(_) => (State::Refused, None),
            Error::NotResumable { .. } => (State::Refused, Some(Refusal::NotResumable)),
            Error::Folder(refused) => (State::Refused, refusal(refused)),
            Error::Results(_) | Error::Failed(_) => (State::Failed, None),
            Error::Interrupted => (State::Stopped, None),
        };
        let message = match error {
            Error::Interrupted => "stopped: nothing was computed yet".to_owned(),
            error => error.to_string(),
        };
        let message = Some(message.replace(&format!("{}/", root.display()), ""));
        Self { folder: None, state, message, refusal }
    }
}

fn refusal(of: &FolderRefused) -> Option<Refusal> {
    match of {
        FolderRefused::Occupied { .. } => Some(Refusal::Occupied),
        FolderRefused::Unfinished { .. } => Some(Refusal::Unfinished),
        FolderRefused::Busy { .. } | FolderRefused::ShareBusy { .. } => Some(Refusal::Busy),
        FolderRefused::AllOccupied { .. } => None,
    }
}
