//! Checks a TOML text against the schema: as much of JSON Schema as the schema uses.

use std::{cell::RefCell, collections::HashMap};

use regex::Regex;
use serde_json::{Value as Json, json};
use toml::de::{DeTable, DeValue};

/// Returns the violations of a schema by a TOML text, each with its place and reason.
pub(crate) fn problems(schema: &Json, toml: &str) -> Vec<String> {
    let table = DeTable::parse(toml).expect("TOML");
    let mut problems = Vec::new();
    check(schema, &object(table.get_ref()), "case", &mut problems);
    problems
}

fn object(table: &DeTable<'_>) -> Json {
    let entries = table.iter();
    Json::Object(
        entries
            .map(|(key, value)| (key.get_ref().to_string(), converted(value.get_ref())))
            .collect(),
    )
}

fn converted(value: &DeValue<'_>) -> Json {
    match value {
        DeValue::String(text) => json!(text),
        DeValue::Integer(integer) => match i64::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(whole) => json!(whole),
            Err(_) => json!(1e300),
        },
        // JSON has no NaN and no infinity, so that they are not numbers there either.
        DeValue::Float(float) => float.as_str().parse::<f64>().map_or(Json::Null, |v| json!(v)),
        DeValue::Boolean(value) => json!(value),
        DeValue::Datetime(_) => Json::Null,
        DeValue::Array(items) => items.iter().map(|item| converted(item.get_ref())).collect(),
        DeValue::Table(table) => object(table),
    }
}

fn check(schema: &Json, value: &Json, at: &str, problems: &mut Vec<String>) {
    for (word, rule) in schema.as_object().expect("a schema is an object") {
        let valid = match word.as_str() {
            "$schema" | "title" | "description" | "default" | "examples" | "x-usual"
            | "x-dimension" | "x-order" | "x-unit" => true,
            "required" | "additionalProperties" | "prefixItems" => true,
            "anyOf" => any_of(rule, value, at),
            "type" => is_of_type(rule.as_str().expect("a type"), value),
            "enum" => rule.as_array().expect("words").contains(value),
            "const" => rule == value,
            "minimum" => value.as_f64().is_none_or(|v| v >= rule.as_f64().expect("a number")),
            "maximum" => value.as_f64().is_none_or(|v| v <= rule.as_f64().expect("a number")),
            "exclusiveMinimum" => {
                value.as_f64().is_none_or(|v| v > rule.as_f64().expect("a number"))
            }
            "minItems" => length(value).is_none_or(|n| n >= rule.as_u64().expect("a number")),
            "maxItems" => length(value).is_none_or(|n| n <= rule.as_u64().expect("a number")),
            "minLength" => value.as_str().is_none_or(|t| !t.is_empty()),
            "maxLength" => value
                .as_str()
                .is_none_or(|t| t.chars().count() as u64 <= rule.as_u64().expect("a number")),
            "pattern" => {
                value.as_str().is_none_or(|text| matches(rule.as_str().expect("a pattern"), text))
            }
            "items" => {
                for (i, item) in value.as_array().into_iter().flatten().enumerate() {
                    check(rule, item, &format!("{at}.{i}"), problems);
                }
                true
            }
            "properties" => {
                check_object(schema, value, at, problems);
                true
            }
            other => panic!("the schema has `{other}`, which is not checked here"),
        };
        if !valid {
            problems.push(format!("{at}: {value} against {word} {rule}"));
        }
    }
    if let (Some(cells), Some(items)) = (schema.get("prefixItems"), value.as_array()) {
        for (i, (cell, item)) in cells.as_array().expect("cells").iter().zip(items).enumerate() {
            check(cell, item, &format!("{at}.{i}"), problems);
        }
    }
}

fn any_of(rules: &Json, value: &Json, at: &str) -> bool {
    let rules = rules.as_array().expect("schemas");
    rules.iter().any(|rule| {
        let mut problems = Vec::new();
        check(rule, value, at, &mut problems);
        problems.is_empty()
    })
}

fn check_object(schema: &Json, value: &Json, at: &str, problems: &mut Vec<String>) {
    let Some(object) = value.as_object() else {
        return;
    };
    let keys = schema["properties"].as_object().expect("properties");
    assert_eq!(schema["additionalProperties"], json!(false), "{at} is open");
    for (key, value) in object {
        match keys.get(key) {
            Some(rule) => check(rule, value, &format!("{at}.{key}"), problems),
            None => problems.push(format!("{at}: unknown key {key}")),
        }
    }
    for key in schema.get("required").and_then(Json::as_array).into_iter().flatten() {
        if !object.contains_key(key.as_str().expect("a key")) {
            problems.push(format!("{at}: lacks {key}"));
        }
    }
}

fn is_of_type(name: &str, value: &Json) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        other => panic!("the schema has a type `{other}`, which is not checked here"),
    }
}

fn length(value: &Json) -> Option<u64> {
    value.as_array().map(|items| items.len() as u64)
}

/// Whether a text matches a pattern. A schema has few patterns, and they are tried on thousands of
/// texts.
fn matches(pattern: &str, text: &str) -> bool {
    thread_local! {
        static PATTERNS: RefCell<HashMap<String, Regex>> = RefCell::default();
    }
    PATTERNS.with_borrow_mut(|patterns| {
        let regex = patterns
            .entry(pattern.to_owned())
            .or_insert_with(|| Regex::new(pattern).expect("a regular expression"));
        regex.is_match(text)
    })
}
