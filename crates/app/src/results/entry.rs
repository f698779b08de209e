//! A results folder in a list.

use std::{
    fs::{self, File},
    io::Read,
    path::Path,
    time::SystemTime,
};

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;
use wholestring_results::Occupant;
use wholestring_runner::results_kind;

use super::checks::{of_summary, summary};
use crate::workspace::{ResultsPlace, millis};

/// A results folder.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ResultsEntry {
    /// Identifier in requests.
    id: String,
    /// Path within the folder, for display.
    path: String,
    /// The command that wrote it: `run`, `plan`, `study`, ...
    kind: String,
    /// Name of the case or the study.
    name: String,
    /// Time when it was written, milliseconds since 1970.
    modified_ms: u64,
    /// The version of the program that wrote it, if known.
    engine_version: Option<String>,
    /// Whether it has stopped work that can be continued.
    unfinished: bool,
    /// Number of errors in the results.
    errors: usize,
    /// Number of warnings.
    warnings: usize,
    /// Number of notes.
    notes: usize,
    /// Whether it has a page.
    has_page: bool,
}

/// The page of a results folder.
pub(super) const PAGE: &str = "report.html";

/// Leading bytes of a page that contain the program which made it.
const HEAD: usize = 4096;

impl ResultsEntry {
    pub(super) fn id(&self) -> &str {
        &self.id
    }

    pub(super) fn kind(&self) -> &str {
        &self.kind
    }

    pub(super) const fn modified_ms(&self) -> u64 {
        self.modified_ms
    }

    /// The results at a path.
    pub(crate) fn of(place: &ResultsPlace) -> Self {
        let (folder, summary) = (&place.path, summary(&place.path));
        let occupant = Occupant::of_folder(folder);
        let found = summary.as_ref().map(of_summary).unwrap_or_default();
        let count = |level: &str| found.iter().filter(|check| check.is(level)).count();
        Self {
            id: place.id.clone(),
            path: place.shown.clone(),
            kind: kind(folder, occupant.as_ref()),
            name: name(place, summary.as_ref(), occupant.as_ref()),
            modified_ms: millis(modified(folder)),
            engine_version: version(folder, summary.as_ref()),
            unfinished: is_unfinished(folder, 0),
            errors: count("error"),
            warnings: count("warning"),
            notes: count("note"),
            has_page: folder.join(PAGE).is_file(),
        }
    }
}

/// The command that wrote it; for unfinished work, taken from the folder itself.
fn kind(folder: &Path, occupant: Option<&Occupant>) -> String {
    if let Some(occupant) = occupant {
        return occupant.kind.clone();
    }
    let noun = results_kind(folder).unwrap_or("results");
    noun.trim_start_matches("an ").trim_start_matches("a ").to_owned()
}

fn name(place: &ResultsPlace, summary: Option<&Value>, occupant: Option<&Occupant>) -> String {
    let name = summary.and_then(|summary| summary["case"].as_str()).map(str::to_owned);
    let name = name.or_else(|| occupant.map(|occupant| occupant.name.clone()));
    name.unwrap_or_else(|| place.shown.rsplit('/').next().unwrap_or_default().to_owned())
}

/// Time when the file that marks completion was written, or that of the folder if it is missing.
fn modified(folder: &Path) -> SystemTime {
    let names = ["summary.json", "sweep.csv", PAGE, "."];
    let mut times = names.iter().filter_map(|name| fs::metadata(folder.join(name)).ok());
    let time = times.find_map(|about| about.modified().ok());
    time.unwrap_or(SystemTime::UNIX_EPOCH)
}

fn version(folder: &Path, summary: Option<&Value>) -> Option<String> {
    let version = summary.and_then(|summary| summary["engine_version"].as_str());
    version.map(str::to_owned).or_else(|| {
        let mut head = Vec::new();
        File::open(folder.join(PAGE)).ok()?.take(HEAD as u64).read_to_end(&mut head).ok()?;
        let head = String::from_utf8_lossy(&head);
        let (_, rest) = head.split_once("name=\"generator\" content=\"wholestring ")?;
        Some(rest.split('"').next()?.to_owned())
    })
}

/// Whether it, or the folder of one of its cases, has a checkpoint.
fn is_unfinished(folder: &Path, depth: usize) -> bool {
    if folder.join("checkpoint.bin").is_file() {
        return true;
    }
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut folders =
        entries.filter(|entry| depth < 2 && entry.file_type().is_ok_and(|kind| kind.is_dir()));
    folders.any(|entry| is_unfinished(&entry.path(), depth + 1))
}
