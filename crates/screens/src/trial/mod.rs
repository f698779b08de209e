//! Trial values in place of those of a text: the changes that they make, and whether they are
//! valid.

mod comments;
mod friction;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value as Json;
use utoipa::ToSchema;
use wholestring::well::HoleKind;
use wholestring_case::{Case, Edit, Files, Override, edit, long_key, parse};
use wholestring_config::node::{Entries, Node, Value, parse_text};
use wholestring_units::{Dimension, UnitSet};

pub use comments::{Comment, Fate};
pub(crate) use friction::Frictions;

use crate::{diagnostic, refusal::Refusal};

/// The key of the factor on every section's own friction.
pub(crate) const MULTIPLIER: &str = "friction_multiplier";

/// The key of one friction for all sections.
pub(crate) const UNIFORM: &str = "friction";

/// A key of the case and its new value, as in `--set`.
pub(crate) type KeyValue = (String, String);

/// The keys of a text that these values set: `friction_multiplier` and `friction` set those of
/// every hole section and of the plan.
///
/// # Errors
/// A text that is not TOML, a friction that is not a number, and both kinds of it at once.
pub(crate) fn key_values(
    text: &str,
    set: &BTreeMap<String, String>,
) -> Result<Vec<KeyValue>, Refusal> {
    let number = |key: &str| -> Result<Option<f64>, Refusal> {
        let Some(value) = set.get(key) else { return Ok(None) };
        let found = value.trim().parse().ok().filter(|number: &f64| number.is_finite());
        let message = || format!("`{key}` is no number: `{value}`");
        found.map(Some).ok_or_else(|| Refusal::bad_input(message()))
    };
    let (factor, coefficient) = (number(MULTIPLIER)?, number(UNIFORM)?);
    let numbers = match (factor, coefficient) {
        (None, None) => Vec::new(),
        (Some(factor), None) => frictions(text)?.scaled(factor),
        (None, Some(coefficient)) => frictions(text)?.uniform(coefficient),
        (Some(_), Some(_)) => {
            let message = format!("`{MULTIPLIER}` and `{UNIFORM}` exclude each other");
            return Err(Refusal::bad_input(message));
        }
    };
    let is_friction = |key: &str| key == MULTIPLIER || key == UNIFORM;
    let others = set.iter().filter(|(key, _)| !is_friction(key));
    let others = others.map(|(key, value)| (long_key(key).to_owned(), value.clone()));
    let numbers = numbers.into_iter().map(|(key, value)| (key, value.to_string()));
    Ok(numbers.chain(others).collect())
}

fn frictions(text: &str) -> Result<Frictions, Refusal> {
    let root = parse_text(text, 0);
    let root = root.map_err(|_| Refusal::bad_input("the text is not TOML"))?;
    Ok(Frictions::of(&root))
}

/// The same as changes of a case.
///
/// # Errors
/// The same.
pub(crate) fn overrides(
    text: &str,
    set: &BTreeMap<String, String>,
) -> Result<Vec<Override>, Refusal> {
    let one = |(key, value): KeyValue| {
        let change = format!("{key}={value}").parse::<Override>();
        change.map_err(|error| Refusal::bad_input(error.to_string()))
    };
    key_values(text, set)?.into_iter().map(one).collect()
}

/// Trial values to be written into the text.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Applying {
    /// The text.
    text: String,
    /// Values by key, as in `--set KEY=VALUE`; `friction_multiplier` scales every section's own
    /// friction and that of the plan, `friction` applies to all sections alike.
    set: BTreeMap<String, String>,
    /// Treatments of comments, by their first lines; for others, the proposals of [`Applied`].
    #[serde(default)]
    comments: BTreeMap<usize, Fate>,
}

/// A changed key.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ChangedKey {
    /// The dotted key.
    key: String,
    /// Its label for display: `Friction, casing to 5110 ft`.
    label: String,
    /// Its written value; null if the key is new.
    old: Option<String>,
    /// Its new written value.
    new: String,
}

/// A text with other values written into it.
#[derive(Debug, Serialize, ToSchema)]
pub struct Applied {
    /// The text.
    text: String,
    /// The changed keys.
    changes: Vec<ChangedKey>,
    /// The comments that may refer to the changes, with their treatments.
    comments: Vec<Comment>,
    /// Warnings that the text did not have before.
    warnings: Vec<String>,
}

impl Applying {
    /// The text with these values, and the changes; nothing is written. A text that would be no
    /// valid case is refused.
    ///
    /// # Errors
    /// Values that the case cannot have, with the reasons.
    pub fn apply(self, name: &str, files: &dyn Files) -> Result<Applied, Refusal> {
        let Self { text, set, comments: fates } = self;
        let root = parse_text(&text, 0);
        let root = root.map_err(|_| Refusal::bad_input("the text is not TOML"))?;
        let before = parse(name, text.as_bytes(), files, &[])?;
        let pairs = key_values(&text, &set)?;
        let mut changes = Vec::new();
        let mut edits = Vec::new();
        let mut places = Vec::new();
        for (key, value) in &pairs {
            let node = at(&root, key);
            let old = node.map(|node| bare(&text[node.place.start..node.place.end]));
            let to = json(value);
            let new = to.as_str().map_or_else(|| to.to_string(), str::to_owned);
            if old == Some(new.as_str()) {
                continue;
            }
            if let Some(node) = node {
                let name = key.rsplit('.').next().unwrap_or_default();
                let (start, end) = (node.place.start, node.place.end);
                places.push(comments::Written { name, start, end });
            }
            changes.push(ChangedKey {
                label: label(&before, key),
                key: key.clone(),
                old: old.map(str::to_owned),
                new,
            });
            edits.push(Edit::Set { key: key.clone(), to });
        }
        let mut found = comments::comments(&text, &places);
        for comment in &mut found {
            comment.fate = fates.get(&comment.line).copied().unwrap_or(comment.fate);
        }
        let treated = comments::treated(&text, &found);
        let edited = edit(&treated, &edits);
        let edited = edited.map_err(|error| Refusal::bad_input(error.to_string()))?;
        let after = parse(name, edited.as_bytes(), files, &[]).map_err(|report| {
            let message = "not applied: the case would not be valid with these values";
            let mut refusal = Refusal::new(422, "unsound", message);
            refusal.error.diagnostics = diagnostic::of_report(&report);
            refusal
        })?;
        let had: Vec<&String> =
            before.warnings.diagnostics.iter().map(|one| &one.message).collect();
        let warnings = after.warnings.diagnostics.into_iter().map(|one| one.message);
        let warnings = warnings.filter(|one| !had.contains(&one)).collect();
        Ok(Applied { text: edited, changes, comments: found, warnings })
    }
}

/// A value of `--set` as written in the file: a bare number is a number there, too.
fn json(value: &str) -> Json {
    let number = value.parse::<f64>().ok().filter(|number| number.is_finite());
    match (value.parse::<i64>(), number) {
        (Ok(whole), _) => whole.into(),
        (_, Some(number)) => number.into(),
        _ => value.into(),
    }
}

/// A value without its quotes.
fn bare(written: &str) -> &str {
    written.trim_matches(['"', '\''])
}

/// The value of a dotted key.
fn at<'a>(root: &'a Entries, key: &str) -> Option<&'a Node> {
    let mut parts = key.split('.');
    let mut node = root.get(parts.next()?)?;
    for part in parts {
        node = match &node.value {
            Value::Table(table) => table.get(part)?,
            Value::List(items) => items.get(part.parse::<usize>().ok()?)?,
            _ => return None,
        };
    }
    Some(node)
}

/// The label of a key.
fn label(case: &Case, key: &str) -> String {
    let parts: Vec<&str> = key.split('.').collect();
    match parts.as_slice() {
        ["well", "hole", place, "friction", rest @ ..] => {
            let place = place.parse().ok();
            let named = place.and_then(|place| section(case, place)).unwrap_or_default();
            format!("Friction{}, {named}", of_coefficient(rest))
        }
        ["plan", "friction", level, rest @ ..] => {
            let (kind, rest) = match rest {
                ["cased", rest @ ..] => (", casing", rest),
                ["open", rest @ ..] => (", open hole", rest),
                rest => ("", rest),
            };
            format!("Plan, {level} friction{}{kind}", of_coefficient(rest))
        }
        ["operation", "wob"] => "Weight on bit".to_owned(),
        ["operation", "rpm"] => "Rotary speed".to_owned(),
        ["operation", "bit_depth"] => "Bit depth".to_owned(),
        ["mud", "density"] => "Mud density".to_owned(),
        _ => key.to_owned(),
    }
}

fn of_coefficient(rest: &[&str]) -> &'static str {
    match rest {
        ["static"] => " at rest",
        ["around"] => " around the hole",
        _ => "",
    }
}

/// The label of a hole section, in the order of the file.
pub(crate) fn section(case: &Case, place: usize) -> Option<String> {
    let section = case.model.well.hole.sections().get(place)?;
    let kind = match section.kind {
        HoleKind::Casing => "casing",
        HoleKind::Open => "open hole",
    };
    let to = depth(section.to_md_m, case.units);
    Some(format!("{kind} to {to}"))
}

fn depth(md_m: f64, units: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(units);
    format!("{:.0} {}", unit.from_si(md_m), unit.symbol)
}

#[cfg(test)]
mod tests;
