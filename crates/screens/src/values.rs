//! TOML as JSON.

use serde_json::{Map, Value as Json, json};
use wholestring_config::node::{Entries, Node, Value};

/// A table as JSON. Numbers and texts are unchanged; a date becomes its text, and so does a number
/// that JSON lacks.
pub(super) fn of_table(entries: &Entries, text: &str) -> Json {
    let pairs = entries.0.iter().map(|(key, node)| (key.name.clone(), of_node(node, text)));
    Json::Object(pairs.collect::<Map<String, Json>>())
}

fn of_node(node: &Node, text: &str) -> Json {
    let as_written = || json!(text.get(node.place.start..node.place.end).unwrap_or_default());
    match &node.value {
        Value::Text { text, .. } => json!(text),
        Value::Number { whole: Some(whole), .. } => json!(whole),
        Value::Number { value, .. } if value.is_finite() => json!(value),
        Value::Number { .. } | Value::Date => as_written(),
        Value::Boolean(truth) => json!(truth),
        Value::List(items) => items.iter().map(|item| of_node(item, text)).collect(),
        Value::Table(entries) => of_table(entries, text),
    }
}
