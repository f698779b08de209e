//! What was found in results, whatever command left them.

use std::{fs, path::Path};

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;

/// Longer summaries are not looked through, bytes.
const LONGEST: u64 = 16 << 20;

/// Findings that are listed.
const LISTED: usize = 200;

/// Something that was found, once for all the depths at which it was.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct Found {
    /// `error`, `warning` or `note`.
    level: String,
    /// What, as a word for programs: `helical_buckling`.
    kind: String,
    /// The operation and the model: `trip in (soft)`.
    of: String,
    /// A sentence, of the first place where it was found.
    message: String,
    /// How often it was found.
    times: usize,
}

impl Found {
    /// Whether it is of this level.
    pub(super) fn is(&self, level: &str) -> bool {
        self.level == level
    }
}

/// The summary of a folder of results as JSON; none where there is none yet.
pub(super) fn summary(folder: &Path) -> Option<Value> {
    let path = folder.join("summary.json");
    if fs::metadata(&path).ok()?.len() > LONGEST {
        return None;
    }
    serde_json::from_slice(&fs::read(path).ok()?).ok()
}

/// What was found in a folder of results, the gravest first.
pub(crate) fn findings(folder: &Path) -> Vec<Found> {
    summary(folder).map_or_else(Vec::new, |summary| of_summary(&summary))
}

/// The same of its summary.
pub(super) fn of_summary(summary: &Value) -> Vec<Found> {
    let mut found = Vec::new();
    collect(summary, "", &mut found);
    found.sort_by_key(|of| place(&of.level));
    found.truncate(LISTED);
    found
}

/// How grave a level is, the gravest first.
fn place(level: &str) -> usize {
    ["error", "warning"].iter().position(|of| *of == level).unwrap_or(2)
}

/// Findings are objects with a level and a kind, in an operation of a model, at any depth.
fn collect(value: &Value, of: &str, found: &mut Vec<Found>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| collect(item, of, found)),
        Value::Object(entries) => {
            let text = |key: &str| entries.get(key).and_then(Value::as_str);
            if let (Some(level), Some(kind)) = (text("level"), text("kind")) {
                let same =
                    |one: &&mut Found| one.level == level && one.kind == kind && one.of == of;
                match found.iter_mut().find(same) {
                    Some(known) => known.times += 1,
                    None => found.push(Found {
                        level: level.to_owned(),
                        kind: kind.to_owned(),
                        of: of.to_owned(),
                        message: text("message").map_or_else(|| words(kind), str::to_owned),
                        times: 1,
                    }),
                }
                return;
            }
            let own = match (text("operation"), text("model")) {
                (Some(operation), Some(model)) => format!("{} ({model})", words(operation)),
                (Some(operation), None) => words(operation),
                _ => of.to_owned(),
            };
            // What was put in holds no findings.
            let inner = entries.iter().filter(|(key, _)| *key != "settings");
            inner.for_each(|(_, value)| collect(value, &own, found));
        }
        _ => {}
    }
}

fn words(name: &str) -> String {
    name.replace('_', " ")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn findings_are_counted_by_operation() {
        let finding = |level: &str| json!({"level": level, "kind": "helical_buckling"});
        let summary = json!({
            "settings": {"trap": finding("error")},
            "operations": [
                {"model": "soft", "operation": "trip_in", "findings": [
                    {"level": "note", "kind": "neutral_point", "message": "Neutral at 900 m"}]},
            ],
            "points": [
                {"model": "soft", "operation": "slide", "bit_depth_m": 1.0, "worst": finding("error")},
                {"model": "soft", "operation": "slide", "bit_depth_m": 2.0, "worst": finding("error")},
                {"model": "soft", "operation": "slide", "bit_depth_m": 3.0, "worst": null},
            ],
        });
        let found = of_summary(&summary);
        let lines: Vec<_> = found.iter().map(|of| (&*of.of, &*of.message, of.times)).collect();
        assert_eq!(
            lines,
            [("slide (soft)", "helical buckling", 2), ("trip in (soft)", "Neutral at 900 m", 1)]
        );
    }
}
