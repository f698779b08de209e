//! The description of the API for programs.

use std::collections::BTreeSet;

use axum::{Router, http::header, response::IntoResponse, routing::get};
use serde_json::{Value, json};
use utoipa::openapi::{Info, OpenApi};

use crate::app::App;

/// `GET /api/openapi.json`.
pub(super) fn routes(mut document: OpenApi) -> Router<App> {
    document.info = Info::new("wholestring app", env!("CARGO_PKG_VERSION"));
    // It consists of strings and lists; if serialization failed, the empty text would reveal it.
    let mut document = serde_json::to_value(&document).unwrap_or_default();
    complete(&mut document);
    let text = document.to_string();
    let answer = async move || ([(header::CONTENT_TYPE, "application/json")], text).into_response();
    Router::new().route("/api/openapi.json", get(answer))
}

/// Makes the properties of answers that may be null required: an answer always has them, whereas
/// a request may leave them out.
fn complete(document: &mut Value) {
    let requests = requests(document);
    let schemas = document["components"]["schemas"].as_object_mut().into_iter().flatten();
    for (_, schema) in schemas.filter(|(name, _)| !requests.contains(*name)) {
        require_nullable(schema);
    }
}

/// Names of the schemas of requests: those of bodies, and those that refuse unknown properties,
/// with all that they refer to.
fn requests(document: &Value) -> BTreeSet<String> {
    let mut names = Vec::new();
    let methods = document["paths"].as_object().into_iter().flat_map(|paths| paths.values());
    for method in methods.filter_map(Value::as_object).flat_map(|methods| methods.values()) {
        named(&method["requestBody"], &mut names);
    }
    let schemas = &document["components"]["schemas"];
    for (name, schema) in schemas.as_object().into_iter().flatten() {
        if schema["additionalProperties"] == json!(false) {
            names.push(name.clone());
        }
    }
    let mut found = BTreeSet::new();
    while let Some(name) = names.pop() {
        if found.insert(name.clone()) {
            named(&schemas[&name], &mut names);
        }
    }
    found
}

/// Adds the names of the schemas that a part of the document refers to.
fn named(part: &Value, names: &mut Vec<String>) {
    match part {
        Value::Object(entries) => {
            let place = entries.get("$ref").and_then(Value::as_str);
            names.extend(place.and_then(|place| place.rsplit('/').next()).map(str::to_owned));
            entries.values().for_each(|part| named(part, names));
        }
        Value::Array(parts) => parts.iter().for_each(|part| named(part, names)),
        _ => {}
    }
}

/// Makes all nullable properties in a schema required.
fn require_nullable(schema: &mut Value) {
    let nullable = schema["properties"].as_object().into_iter().flatten();
    let nullable: Vec<Value> =
        nullable.filter(|(_, schema)| is_nullable(schema)).map(|(name, _)| json!(name)).collect();
    if let Value::Object(entries) = schema {
        if !nullable.is_empty() {
            let required = entries.entry("required").or_insert_with(|| json!([]));
            for name in nullable {
                if let Value::Array(required) = required
                    && !required.contains(&name)
                {
                    required.push(name);
                }
            }
        }
        for key in ["allOf", "oneOf"] {
            let parts = entries.get_mut(key).and_then(Value::as_array_mut).into_iter().flatten();
            parts.for_each(require_nullable);
        }
    }
}

fn is_nullable(schema: &Value) -> bool {
    let kinds = schema["type"].as_array().into_iter().flatten();
    let choices = schema["oneOf"].as_array().into_iter().flatten();
    kinds.chain(choices.map(|choice| &choice["type"])).any(|kind| kind == "null")
}
