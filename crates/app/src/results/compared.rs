//! Comparison of results.

use std::{collections::BTreeMap, path::Path};

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;
use wholestring::outcome::QuantityKind;
use wholestring_results::{PlanSummary, Summary};
use wholestring_runner::{
    Comparison,
    checks::quantities::{shown, symbol},
};
use wholestring_units::UnitSet;

use super::{
    curves::{Curve, curves},
    entry::{ResultsEntry, summary},
};
use crate::workspace::ResultsPlace;

/// Results side by side.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Compared {
    /// The compared results, in the order of the request.
    results: Vec<ResultsEntry>,
    /// The inputs that differ between them.
    inputs: Vec<Differing>,
    /// Numbers that at least one of them has.
    scalars: Vec<ComparedScalar>,
    /// Curves against depth of those that have some.
    curves: Vec<Curve>,
}

/// A number of the results.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ComparedScalar {
    /// Its operation and model: `trip out (soft)`.
    of: String,
    /// Its label: `Hook load`.
    label: String,
    /// The symbol of its unit.
    unit: String,
    /// Its value in each of the results; null if it has none.
    values: Vec<Option<f64>>,
}

/// Compares results, in these units.
pub(crate) fn compare(places: &[ResultsPlace], units: UnitSet) -> Compared {
    let summaries: Vec<Option<Value>> = places.iter().map(|place| summary(&place.path)).collect();
    let settings: Vec<Option<&Value>> = summaries
        .iter()
        .map(|parsed| parsed.as_ref().map(|summary| &summary["settings"]))
        .collect();
    let mut rows: Vec<ComparedScalar> = Vec::new();
    for (place, (results, summary)) in places.iter().zip(&summaries).enumerate() {
        let Some(summary) = summary else { continue };
        for Scalar { of: scalar, label, unit, value } in scalars(&results.path, summary, units) {
            let row = rows.iter().position(|row| row.of == scalar && row.label == label);
            let row = row.unwrap_or_else(|| {
                let values = vec![None; places.len()];
                rows.push(ComparedScalar { of: scalar, label, unit, values });
                rows.len() - 1
            });
            rows[row].values[place] = Some(value);
        }
    }
    Compared {
        inputs: differing(&settings),
        scalars: rows,
        curves: places
            .iter()
            .enumerate()
            .flat_map(|(k, place)| curves(&place.path, k, units))
            .collect(),
        results: places.iter().map(ResultsEntry::of).collect(),
    }
}

// Inputs that differ between results.

/// Maximum length of a list whose values are shown; for longer ones only the number of values is.
const LISTED: usize = 80;

/// An input that differs between the results.
#[derive(Debug, PartialEq, Serialize, ToSchema)]
pub(crate) struct Differing {
    /// Its key in the record of the settings, with the SI unit in its name.
    key: String,
    /// Its value in each of the results; null if it has none.
    values: Vec<Option<String>>,
}

/// The settings that differ, by key.
pub(super) fn differing(settings: &[Option<&Value>]) -> Vec<Differing> {
    let leaves: Vec<BTreeMap<String, String>> = settings
        .iter()
        .map(|setting| {
            let mut leaves = BTreeMap::new();
            if let Some(value) = setting {
                flatten(value, String::new(), &mut leaves);
            }
            leaves
        })
        .collect();
    let mut keys: Vec<&String> = leaves.iter().flat_map(BTreeMap::keys).collect();
    keys.sort();
    keys.dedup();
    let values = |key: &String| -> Vec<Option<String>> {
        leaves.iter().map(|leaf| leaf.get(key).cloned()).collect()
    };
    let all = keys.into_iter().map(|key| Differing { key: key.clone(), values: values(key) });
    all.filter(|input| input.values.windows(2).any(|two| two[0] != two[1])).collect()
}

fn flatten(value: &Value, key: String, leaves: &mut BTreeMap<String, String>) {
    let within = |part: &str| match key.is_empty() {
        true => part.to_owned(),
        false => format!("{key}.{part}"),
    };
    match value {
        Value::Object(entries) => {
            entries.iter().for_each(|(part, value)| flatten(value, within(part), leaves));
        }
        Value::Array(items) if items.iter().any(Value::is_object) => {
            let items = items.iter().enumerate();
            items.for_each(|(place, value)| flatten(value, within(&place.to_string()), leaves));
        }
        Value::Array(items) => {
            let text = value.to_string();
            let text = match text.len() <= LISTED {
                true => text,
                // Two different long lists must not look alike.
                false => format!(
                    "{} values, {}",
                    items.len(),
                    crate::workspace::fingerprint(text.as_bytes())
                ),
            };
            leaves.insert(key, text);
        }
        Value::String(text) => drop(leaves.insert(key, text.clone())),
        Value::Null => {}
        other => drop(leaves.insert(key, other.to_string())),
    }
}

// The numbers of results that are compared with those of others.

/// A number of a result.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scalar {
    /// Its operation and model: `trip out (soft)`.
    pub(super) of: String,
    /// Its label: `Hook load`.
    pub(super) label: String,
    /// The symbol of its unit.
    pub(super) unit: String,
    pub(super) value: f64,
}

/// Maximum number of numbers compared from one summary.
const MOST: usize = 2000;

/// Maximum length of a list; longer ones are curves, not scalars.
const LIST: usize = 60;

/// The numbers of a folder of results, in these units.
pub(super) fn scalars(folder: &Path, summary: &Value, units: UnitSet) -> Vec<Scalar> {
    let path = folder.join("summary.json");
    if let Ok(run) = Summary::read(&path) {
        return of_run(&run, units);
    }
    if let Ok(plan) = PlanSummary::read(&path) {
        return of_plan(&plan, units);
    }
    let mut found = Vec::new();
    collect(summary, &mut Vec::new(), &mut found);
    found.truncate(MOST);
    found
}

fn of_run(summary: &Summary, units: UnitSet) -> Vec<Scalar> {
    let compared = Comparison::of(summary, units);
    let columns = compared.columns.iter().flat_map(|column| {
        let subject = format!("{} ({})", column.operation, column.model);
        compared.rows.iter().zip(&column.values).filter_map(move |(row, value)| {
            let value = value.filter(|value| value.is_finite())?;
            let (label, unit) = (row.label.to_owned(), row.symbol.to_owned());
            Some(Scalar { of: subject.clone(), label, unit, value })
        })
    });
    columns.collect()
}

/// Hook load and torque at the deepest bit depth, and the load that is nearest to its limit.
fn of_plan(summary: &PlanSummary, units: UnitSet) -> Vec<Scalar> {
    let deepest_m = summary.points.iter().map(|point| point.bit_depth_m).fold(f64::NAN, f64::max);
    let deepest = summary.points.iter().filter(|point| point.bit_depth_m == deepest_m);
    let mut found: Vec<Scalar> = deepest
        .filter_map(|deepest| Some((deepest, deepest.scalars?)))
        .flat_map(|(row, scalars)| {
            let name = format!(
                "{} ({}), {} friction, bit at its deepest",
                row.operation, row.model, row.friction
            );
            let scalar = |label: &str, kind, si| Scalar {
                of: name.clone(),
                label: label.to_owned(),
                unit: symbol(kind, units).to_owned(),
                value: shown(kind, si, units),
            };
            [
                scalar("Hook load", QuantityKind::Force, scalars.hook_load_N),
                scalar("Surface torque", QuantityKind::Torque, scalars.surface_torque_N_m),
            ]
        })
        .collect();
    found.extend(summary.checks.iter().filter_map(|row| {
        Some(Scalar {
            of: format!("{}, least reserve", row.operation.words()),
            label: format!("Factor: {}", row.check.kind.label().to_lowercase()),
            unit: String::new(),
            value: row.check.factor?,
        })
    }));
    found
}

/// Numbers at any depth of a summary; items of a list are distinguished by their words.
fn collect(value: &Value, place: &mut Vec<String>, found: &mut Vec<Scalar>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries.iter().filter(|(key, _)| *key != "settings") {
                place.push(key.clone());
                collect(value, place, found);
                place.pop();
            }
        }
        Value::Array(items) if items.len() <= LIST => {
            let names: Vec<String> = items.iter().map(words).collect();
            let told_apart = |name: &String| {
                !name.is_empty() && names.iter().filter(|other| *other == name).count() == 1
            };
            for (item, name) in items.iter().zip(&names).filter(|(_, name)| told_apart(name)) {
                place.push(name.clone());
                collect(item, place, found);
                place.pop();
            }
        }
        Value::Number(number) if place.last().is_some_and(|key| key != "schema_version") => {
            let (label, parents) = place
                .split_last()
                .map_or((String::new(), &[][..]), |(key, parents)| (key.clone(), parents));
            found.push(Scalar {
                of: parents.join(", ").replace('_', " "),
                label,
                // Its name ends in the unit.
                unit: String::new(),
                value: number.as_f64().unwrap_or(f64::NAN),
            });
        }
        _ => {}
    }
}

/// The words of an item of a list.
fn words(item: &Value) -> String {
    let entries = item.as_object().into_iter().flatten();
    let words = entries.filter_map(|(_, value)| value.as_str()).filter(|word| word.len() < 40);
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn only_what_differs_is_listed() {
        let one =
            json!({"mud": {"density_kg_per_m3": 1200.0}, "hole": [{"friction": 0.2}], "a": [1]});
        let other =
            json!({"mud": {"density_kg_per_m3": 1300.0}, "hole": [{"friction": 0.2}], "a": [1, 2]});
        let found = differing(&[Some(&one), Some(&other), None]);
        let found: Vec<_> = found.iter().map(|input| (&*input.key, input.values.clone())).collect();
        let text = |text: &str| Some(text.to_owned());
        assert_eq!(found[0], ("a", vec![text("[1]"), text("[1,2]"), None]));
        assert_eq!(found[1], ("hole.0.friction", vec![text("0.2"), text("0.2"), None]));
        assert_eq!(found.len(), 3);
        assert_eq!(differing(&[Some(&one), Some(&one)]), []);
    }

    #[test]
    fn numbers_are_called_by_their_places() {
        let summary = json!({
            "schema_version": 1,
            "settings": {"friction": 0.3},
            "state": {"side_force_N": 120.0, "tilt_rad": null},
            "estimates": [{"name": "friction_cased", "value": 0.2}, {"name": "friction_open", "value": 0.3}],
            "alike": [{"name": "a", "value": 1.0}, {"name": "a", "value": 2.0}],
        });
        let mut found = Vec::new();
        collect(&summary, &mut Vec::new(), &mut found);
        let mut found: Vec<_> = found
            .iter()
            .map(|scalar| (scalar.of.clone(), scalar.label.clone(), scalar.value))
            .collect();
        found.sort_by(|a, b| a.0.cmp(&b.0));
        assert_eq!(
            found,
            [
                ("estimates, friction cased".to_owned(), "value".to_owned(), 0.2),
                ("estimates, friction open".to_owned(), "value".to_owned(), 0.3),
                ("state".to_owned(), "side_force_N".to_owned(), 120.0),
            ]
        );
    }
}
