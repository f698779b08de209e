//! TOML as JSON.

use std::{borrow::Cow, collections::BTreeMap};

use serde_json::{Map, Value as Json, json};
use utoipa::{
    PartialSchema, ToSchema,
    openapi::{
        ObjectBuilder, Ref, RefOr, Schema, Type,
        schema::{ArrayBuilder, OneOfBuilder},
    },
};
use wholestring_case::dimension_at;
use wholestring_config::node::{Entries, Node, Value};

/// Description of a value of a case file as JSON.
pub enum CaseValue {}

impl PartialSchema for CaseValue {
    fn schema() -> RefOr<Schema> {
        let own = || Ref::from_schema_name(Self::name());
        let plain = [Type::String, Type::Number, Type::Boolean, Type::Null];
        let any = plain.into_iter().fold(OneOfBuilder::new(), |any, kind| {
            any.item(ObjectBuilder::new().schema_type(kind))
        });
        any.item(ArrayBuilder::new().items(own()))
            .item(ObjectBuilder::new().additional_properties(Some(own())))
            .description(Some("A value of a case file."))
            .into()
    }
}

impl ToSchema for CaseValue {
    fn name() -> Cow<'static, str> {
        "CaseValue".into()
    }
}

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

// SI values of the texts in a case.

/// SI value of each quantity, by dimension and text: `{"length": {"10 ft": 3.048}}`. Texts that are
/// no quantity are omitted.
pub(super) type Quantities = BTreeMap<&'static str, BTreeMap<String, f64>>;

/// The quantities of a case's tables.
pub(super) fn quantities_of_table(entries: &Entries) -> Quantities {
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
