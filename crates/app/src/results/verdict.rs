//! The verdict on a case, from its existing results.

use std::{
    collections::HashMap,
    fs, mem,
    path::PathBuf,
    sync::{Arc, Mutex, PoisonError},
    time::{Duration, Instant, SystemTime},
};

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;
use wholestring_judge::Overall;
use wholestring_results::checks_of;
use wholestring_screens::words::Severity;

use super::{ResultsEntry, entry::summary};
use crate::workspace::{ResultsPlace, Workspace};

/// Parts of the settings that change the answer of a case; models, depths of a plan, records and
/// names do not.
const PHYSICS: [&str; 10] =
    ["bit", "buckling", "ends", "hoist", "mud", "operation", "rig", "string", "top_drive", "well"];

/// Relative tolerance for settings that were read back with an error in their last digit.
const READ_BACK: f64 = 1e-12;

/// The judge's verdict on a case, from its newest results.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct CaseVerdict {
    /// Its severity.
    #[schema(value_type = Severity)]
    severity: &'static str,
    /// The verdict in words.
    words: String,
    /// The command of the results: `run`, `plan`, ...
    kind: String,
    /// Id of the results in requests.
    results: String,
    /// Whether the case is unchanged since it was computed.
    is_current: bool,
}

/// Size of a summary and time of its last change.
type Stamp = (u64, SystemTime);

/// A summary when it was read, and its verdict if it has one.
type Stored = (Stamp, Option<Arc<Known>>);

/// Verdicts of the results of a folder, stored until their summaries change.
#[derive(Debug, Default)]
pub(crate) struct Verdicts(Mutex<HashMap<PathBuf, Stored>>);

#[derive(Debug)]
struct Known {
    entry: ResultsEntry,
    case: String,
    settings: Value,
    overall: Overall,
}

impl Known {
    fn of(place: &ResultsPlace) -> Option<Self> {
        let mut summary = summary(&place.path)?;
        let case = summary["case"].as_str()?.to_owned();
        let checks = checks_of(&summary);
        let overall = Overall::of(checks.iter().map(|named| &named.check))?;
        let settings = summary["settings"].take();
        Some(Self { entry: ResultsEntry::of(place), case, settings, overall })
    }
}

impl Verdicts {
    /// Reads the results of the folder that have a verdict, the newest first, within a time limit.
    pub(crate) fn newest(&self, workspace: &Workspace, reading_time: Duration) -> NewestVerdicts {
        let begin = Instant::now();
        // Values are replaced as a whole: a panic leaves none half written.
        let mut stored = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut former = mem::take(&mut *stored);
        let mut all = Vec::new();
        for place in workspace.results() {
            let about = fs::metadata(place.path.join("summary.json"));
            let Some(stamp) =
                about.ok().and_then(|about| Some((about.len(), about.modified().ok()?)))
            else {
                continue;
            };
            let known = match former.remove(&place.path) {
                Some((same, known)) if same == stamp => known,
                _ if begin.elapsed() >= reading_time => continue,
                _ => Known::of(&place).map(Arc::new),
            };
            all.extend(known.clone());
            stored.insert(place.path, (stamp, known));
        }
        all.sort_by_key(|known| std::cmp::Reverse(known.entry.modified_ms()));
        NewestVerdicts(all)
    }
}

/// Results that have a verdict, the newest first.
#[derive(Debug)]
pub(crate) struct NewestVerdicts(Vec<Arc<Known>>);

impl NewestVerdicts {
    /// The verdict on the case with this name and these settings: from the newest results of
    /// exactly this case or, if there are none, from the newest of an earlier state.
    pub(crate) fn on(&self, name: &str, settings: &Value) -> Option<CaseVerdict> {
        let own = || self.0.iter().filter(|known| known.case == name);
        let current = own().find(|known| is_same_case(&known.settings, settings));
        let known = current.or_else(|| own().next())?;
        Some(CaseVerdict {
            severity: known.overall.severity.name(),
            words: known.overall.words.clone(),
            kind: known.entry.kind().to_owned(),
            results: known.entry.id().to_owned(),
            is_current: current.is_some(),
        })
    }
}

fn is_same_case(one: &Value, other: &Value) -> bool {
    PHYSICS.iter().all(|part| is_same(&one[*part], &other[*part]))
}

fn is_same(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Number(one), Value::Number(other)) => match (one.as_f64(), other.as_f64()) {
            (Some(one), Some(other)) => (one - other).abs() <= READ_BACK * one.abs(),
            (one, other) => one == other,
        },
        (Value::Array(one), Value::Array(other)) => {
            one.len() == other.len()
                && one.iter().zip(other).all(|(one, other)| is_same(one, other))
        }
        (Value::Object(one), Value::Object(other)) => {
            let mut keys = one.keys().chain(other.keys());
            // A key that an earlier version did not write counts as null.
            let none = &Value::Null;
            keys.all(|key| is_same(one.get(key).unwrap_or(none), other.get(key).unwrap_or(none)))
        }
        (one, other) => one == other,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_case_is_the_same_but_for_models_and_last_digits() {
        let one = json!({"model": "soft", "mud": {"density_kg_per_m3": 1200.0}, "well": [1, null]});
        let other = json!({"model": ["stiff"], "mud": {"density_kg_per_m3": 1200.0000000001},
            "well": [1, null], "plan": {}});
        assert!(is_same_case(&one, &other));
        let heavier = json!({"mud": {"density_kg_per_m3": 1201.0}, "well": [1, null]});
        assert!(!is_same_case(&one, &heavier));
        assert!(!is_same_case(
            &one,
            &json!({"mud": {"density_kg_per_m3": 1200.0}, "well": [1, 2]})
        ));
    }
}
