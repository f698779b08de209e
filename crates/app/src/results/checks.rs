//! The checks of results of any command.

use std::{fs, path::Path};

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;
use wholestring_results::checks_of;
use wholestring_screens::words;

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
pub(super) fn of_summary(summary: &Value) -> Vec<Found> {
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
