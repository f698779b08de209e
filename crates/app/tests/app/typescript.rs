//! The types of the page, written from the description of the API.

use std::{env, fs, path::Path};

use serde_json::{Map, Value};

use crate::common::Served;

const HEAD: &str = "// Requests and answers of the server, from its declarations in Rust. Not written by hand:\n\
     // WHOLESTRING_UPDATE_DOCS=1 cargo test -p wholestring-app --test app typescript\n";

/// A comment above a type or a property.
fn comment(schema: &Value, indent: &str) -> String {
    match schema["description"].as_str() {
        Some(text) => format!("{indent}/** {} */\n", text.replace('\n', " ")),
        None => String::new(),
    }
}

/// Types joined, each once.
fn joined(types: impl Iterator<Item = String>, by: &str) -> String {
    let mut all: Vec<String> = Vec::new();
    for one in types {
        if !all.contains(&one) {
            all.push(one);
        }
    }
    all.join(by)
}

/// Properties between braces.
fn braces(schema: &Value, properties: &Map<String, Value>, indent: &str) -> String {
    let required: Vec<&str> =
        schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let inner = format!("{indent}  ");
    let mut text = String::from("{\n");
    for (name, property) in properties {
        let mark = if required.contains(&name.as_str()) { "" } else { "?" };
        text += &comment(property, &inner);
        text += &format!("{inner}{name}{mark}: {};\n", type_of(property, &inner));
    }
    text + indent + "}"
}

fn list(schema: &Value, indent: &str) -> String {
    let item = type_of(&schema["items"], indent);
    match (schema["minItems"].as_u64(), schema["maxItems"].as_u64()) {
        (Some(least), Some(most)) if least == most => {
            let items: Vec<&str> = (0..most).map(|_| item.as_str()).collect();
            format!("[{}]", items.join(", "))
        }
        _ if item.contains(' ') => format!("({item})[]"),
        _ => format!("{item}[]"),
    }
}

fn object(schema: &Value, indent: &str) -> String {
    match (&schema["properties"], &schema["additionalProperties"]) {
        (Value::Object(properties), _) => braces(schema, properties, indent),
        (_, values @ Value::Object(_)) => {
            let values = type_of(values, indent);
            match type_of(&schema["propertyNames"], indent).as_str() {
                "string" | "unknown" => format!("{{ [key: string]: {values} }}"),
                names => format!("Record<{names}, {values}>"),
            }
        }
        _ => "{ [key: string]: unknown }".to_owned(),
    }
}

/// The type of a schema.
fn type_of(schema: &Value, indent: &str) -> String {
    if let Some(place) = schema["$ref"].as_str() {
        return place.rsplit('/').next().unwrap_or_default().to_owned();
    }
    for (key, by) in [("oneOf", " | "), ("allOf", " & ")] {
        if let Some(all) = schema[key].as_array() {
            return joined(all.iter().map(|one| type_of(one, indent)), by);
        }
    }
    if let Some(words) = schema["enum"].as_array() {
        return joined(words.iter().map(Value::to_string), " | ");
    }
    let plain = |kind: &Value| match kind.as_str() {
        Some("array") => list(schema, indent),
        Some("object") => object(schema, indent),
        Some("integer") => "number".to_owned(),
        Some(kind) => kind.to_owned(),
        None => "unknown".to_owned(),
    };
    match &schema["type"] {
        Value::Array(kinds) => joined(kinds.iter().map(plain), " | "),
        kind => plain(kind),
    }
}

fn typescript(document: &Value) -> String {
    let mut text = HEAD.to_owned();
    for (name, schema) in document["components"]["schemas"].as_object().expect("schemas") {
        text += &format!("\n{}", comment(schema, ""));
        text += &match schema["properties"].is_object() {
            true => format!("export interface {name} {}\n", type_of(schema, "")),
            false => format!("export type {name} = {};\n", type_of(schema, "")),
        };
    }
    text
}

/// With `WHOLESTRING_UPDATE_DOCS=1` it writes them.
#[test]
fn the_types_of_the_page_are_those_of_the_document() {
    let document = Served::new().get("/api/openapi.json").ok();
    let expected = typescript(&document);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/app/src/api/types.ts");
    if env::var_os("WHOLESTRING_UPDATE_DOCS").is_some() {
        fs::write(path, expected).expect("written types");
        return;
    }
    let found = fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n");
    assert!(
        found == expected,
        "web/app/src/api/types.ts has other types: WHOLESTRING_UPDATE_DOCS=1 writes those of now"
    );
}
