//! A results folder in a list, its checks, and its page, to be shown inside the app.

use std::{
    fs::{self, File},
    io::Read,
    path::Path,
    time::SystemTime,
};

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;
use wholestring_results::{Occupant, checks_of};
use wholestring_runner::results_kind;
use wholestring_screens::words;

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

// The checks of results of any command.

/// Maximum size of a summary that is searched, bytes.
const LONGEST: u64 = 16 << 20;

/// Maximum number of checks listed.
const LISTED: usize = 200;

/// A check that needs attention, once for all bit depths at which it does.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct Found {
    /// Its severity: `error`, `warning` or `note`.
    #[schema(value_type = words::Severity)]
    severity: &'static str,
    /// Kind of check, an identifier for programs: `helical_buckling`.
    kind: &'static str,
    /// The operation and the model: `trip in (soft)`.
    name: String,
    /// A sentence, for the first place.
    sentence: String,
    /// Number of places.
    times: usize,
}

impl Found {
    /// Whether it is of this severity.
    pub(super) fn is(&self, severity: &str) -> bool {
        self.severity == severity
    }
}

/// The summary of a results folder as JSON; none if there is none yet.
pub(super) fn summary(folder: &Path) -> Option<Value> {
    let path = folder.join("summary.json");
    if fs::metadata(&path).ok()?.len() > LONGEST {
        return None;
    }
    serde_json::from_slice(&fs::read(path).ok()?).ok()
}

/// The checks that need attention in a results folder, the most severe first.
pub(crate) fn checks(folder: &Path) -> Vec<Found> {
    summary(folder).map_or_else(Vec::new, |summary| of_summary(&summary))
}

/// The same from its summary.
fn of_summary(summary: &Value) -> Vec<Found> {
    let mut found: Vec<Found> = Vec::new();
    for named in checks_of(summary).into_iter().filter(|named| !named.check.is_ok()) {
        let (severity, kind) = (named.check.severity.name(), named.check.kind.name());
        let is_same = |one: &&mut Found| {
            one.severity == severity && one.kind == kind && one.name == named.name
        };
        match found.iter_mut().find(is_same) {
            Some(known) => known.times += 1,
            None => found.push(Found {
                severity,
                kind,
                name: named.name,
                sentence: named.check.sentence,
                times: 1,
            }),
        }
    }
    found.truncate(LISTED);
    found
}

// A page of results, to be shown inside the app.

/// Policy of the frame of a page: its own scripts, downloads that the reader requests, and printing
/// by its button. It has an origin of its own, so that its requests are not taken for those of the
/// app, and may send none.
pub(crate) const POLICY: &str = "sandbox allow-scripts allow-downloads allow-modals; \
    default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
    img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'; \
    frame-ancestors 'self'";

/// Links of a page lead to neighbouring files, which a frame without an origin cannot request, so
/// that they are posted to the surrounding app. The page prints when the app requests it.
const SCRIPT: &str = r##"<script>
addEventListener("click", (event) => {
  const link = event.target instanceof Element ? event.target.closest("a[href]") : null;
  const address = link?.getAttribute("href") ?? "#";
  if (/^(#|blob:|data:)/.test(address)) return;
  event.preventDefault();
  parent.postMessage({ file: decodeURIComponent(address) }, "*");
});
addEventListener("message", (event) => {
  if (event.source === parent && event.data === "print") print();
});
</script>
"##;

/// Start of a page's own policy, which would block the app's script.
const OWN_POLICY: &[u8] = b"<meta http-equiv=\"Content-Security-Policy\" content=\"";

/// The page as shown: with the app's script, and with the app's policy in place of its own.
pub(crate) fn page(mut html: Vec<u8>) -> Vec<u8> {
    if let Some(begin) = html.windows(OWN_POLICY.len()).position(|part| part == OWN_POLICY)
        && let Some(length) = html[begin..].iter().position(|byte| *byte == b'>')
    {
        html.drain(begin..=begin + length);
    }
    html.extend_from_slice(SCRIPT.as_bytes());
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_policy_of_a_page_gives_way_to_ours() {
        let own = String::from_utf8_lossy(OWN_POLICY);
        let html = format!("<head>{own}default-src 'none'\">\n<p>");
        let html = String::from_utf8(page(html.into_bytes())).expect("a text");
        assert_eq!(html, format!("<head>\n<p>{SCRIPT}"));
        assert_eq!(page(b"<p>".to_vec()), [&b"<p>"[..], SCRIPT.as_bytes()].concat());
    }
}
