//! A folder of results in a list.

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

/// A folder of results.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ResultsEntry {
    /// What requests call it.
    id: String,
    /// Its place in the folder, for the eye.
    path: String,
    /// What left it: `run`, `plan`, `study`, ...
    kind: String,
    /// What the case is called, or the study.
    name: String,
    /// When it was written, milliseconds since 1970.
    modified_ms: u64,
    /// The version of the program that wrote it, where that is known.
    engine_version: Option<String>,
    /// Whether work was stopped in it that can be continued.
    unfinished: bool,
    /// How many errors were found in the answers.
    errors: usize,
    /// How many warnings.
    warnings: usize,
    /// How many notes.
    notes: usize,
    /// Whether there is a page of it.
    has_page: bool,
}

/// The page of a folder of results.
pub(super) const PAGE: &str = "report.html";

/// What a page says that made it stands in its first bytes.
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

    /// What lies at a place.
    pub(crate) fn of(place: &ResultsPlace) -> Self {
        let (folder, summary) = (&place.path, summary(&place.path));
        let occupant = Occupant::of_folder(folder);
        let found = summary.as_ref().map(of_summary).unwrap_or_default();
        let count = |level: &str| found.iter().filter(|of| of.is(level)).count();
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

/// What left it; of what was only begun, the folder itself says it.
fn kind(folder: &Path, occupant: Option<&Occupant>) -> String {
    if let Some(occupant) = occupant {
        return occupant.kind.clone();
    }
    let noun = results_kind(folder).unwrap_or("results");
    noun.trim_start_matches("an ").trim_start_matches("a ").to_owned()
}

fn name(place: &ResultsPlace, summary: Option<&Value>, occupant: Option<&Occupant>) -> String {
    let said = summary.and_then(|summary| summary["case"].as_str()).map(str::to_owned);
    let said = said.or_else(|| occupant.map(|of| of.name.clone()));
    said.unwrap_or_else(|| place.shown.rsplit('/').next().unwrap_or_default().to_owned())
}

/// When what tells that it is whole was written; where that is missing, the folder itself.
fn modified(folder: &Path) -> SystemTime {
    let names = ["summary.json", "sweep.csv", PAGE, "."];
    let mut times = names.iter().filter_map(|name| fs::metadata(folder.join(name)).ok());
    let time = times.find_map(|about| about.modified().ok());
    time.unwrap_or(SystemTime::UNIX_EPOCH)
}

fn version(folder: &Path, summary: Option<&Value>) -> Option<String> {
    let said = summary.and_then(|summary| summary["engine_version"].as_str());
    said.map(str::to_owned).or_else(|| {
        let mut head = Vec::new();
        File::open(folder.join(PAGE)).ok()?.take(HEAD as u64).read_to_end(&mut head).ok()?;
        let head = String::from_utf8_lossy(&head);
        let (_, rest) = head.split_once("name=\"generator\" content=\"wholestring ")?;
        Some(rest.split('"').next()?.to_owned())
    })
}

/// Whether there is a checkpoint in it, or in the folder of a case of it.
fn is_unfinished(folder: &Path, depth: usize) -> bool {
    if folder.join("checkpoint.bin").is_file() {
        return true;
    }
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut folders =
        entries.filter(|entry| depth < 2 && entry.file_type().is_ok_and(|kind| kind.is_dir()));
    folders.any(|entry| is_unfinished(&entry.path(), depth + 1))
}
