//! The numbers of results that are compared with those of others.

use std::path::Path;

use serde_json::Value;
use wholestring::outcome::QuantityKind;
use wholestring_results::{PlanSummary, Summary};
use wholestring_runner::{
    Comparison,
    checks::quantities::{shown, symbol},
};
use wholestring_units::UnitSet;

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
