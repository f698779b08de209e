//! Inputs that differ between results.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;

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
                    crate::fingerprint::fingerprint(text.as_bytes())
                ),
            };
            leaves.insert(key, text);
        }
        Value::String(text) => drop(leaves.insert(key, text.clone())),
        Value::Null => {}
        other => drop(leaves.insert(key, other.to_string())),
    }
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
}
