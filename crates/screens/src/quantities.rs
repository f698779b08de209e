//! SI values of the texts in a case.

use std::collections::BTreeMap;

use wholestring_case::dimension_at;
use wholestring_config::node::{Entries, Node, Value};

/// SI value of each quantity, by dimension and text: `{"length": {"10 ft": 3.048}}`. Texts that are
/// no quantity are omitted.
pub(super) type Quantities = BTreeMap<&'static str, BTreeMap<String, f64>>;

/// The quantities of a case's tables.
pub(super) fn of_table(entries: &Entries) -> Quantities {
    let mut found = Quantities::new();
    table(entries, "", &mut found);
    found
}

fn table(entries: &Entries, before: &str, found: &mut Quantities) {
    for (key, value) in &entries.0 {
        match before {
            "" => node(value, &key.name, found),
            before => node(value, &format!("{before}.{}", key.name), found),
        }
    }
}

fn node(value: &Node, key: &str, found: &mut Quantities) {
    match &value.value {
        Value::Text { text, .. } => {
            if let Some(dimension) = dimension_at(key)
                && let Ok(si) = dimension.parse(text)
            {
                found.entry(dimension.name()).or_default().insert(text.clone(), si);
            }
        }
        Value::List(items) => {
            for (index, item) in items.iter().enumerate() {
                node(item, &format!("{key}.{index}"), found);
            }
        }
        Value::Table(entries) => table(entries, key, found),
        _ => {}
    }
}
