//! JSON as TOML.

use serde_json::{Map, Value as Json};
use toml_edit::{Array, InlineTable, Item, Table, Value};

/// Keys that identify a table and are written first.
const SAYS_WHAT: [&str; 3] = ["component", "kind", "name"];

/// A value for a key: objects as tables under their own headings, lists of objects as lists of such
/// tables.
pub(super) fn item(json: &Json) -> Result<Item, String> {
    match json {
        Json::Object(object) => Ok(Item::Table(table_of(object)?)),
        Json::Array(items) if !items.is_empty() && items.iter().all(Json::is_object) => {
            let tables = items.iter().filter_map(Json::as_object).map(table_of);
            Ok(Item::ArrayOfTables(tables.collect::<Result<_, _>>()?))
        }
        other => Ok(Item::Value(value(other)?)),
    }
}

/// A table under its heading, with one line for each key.
pub(super) fn table_of(object: &Map<String, Json>) -> Result<Table, String> {
    let mut keys: Vec<&String> = object.keys().collect();
    keys.sort_by_key(|key| !SAYS_WHAT.contains(&key.as_str()));
    let pairs = keys.into_iter().map(|key| Ok::<_, String>((key, value(&object[key])?)));
    pairs.collect()
}

/// A value on one line; a list of lists has a line for each.
pub(super) fn value(json: &Json) -> Result<Value, String> {
    Ok(match json {
        Json::Null => return Err("TOML has no null; remove the key".to_owned()),
        Json::Bool(truth) => (*truth).into(),
        Json::String(text) => text.into(),
        Json::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(whole), _) => whole.into(),
            (None, Some(number)) => number.into(),
            (None, None) => return Err(format!("{number} is not a number of TOML")),
        },
        Json::Array(items) => Value::Array(array(items)?),
        Json::Object(object) => {
            let pairs = object.iter().map(|(key, json)| Ok::<_, String>((key, value(json)?)));
            Value::InlineTable(pairs.collect::<Result<InlineTable, _>>()?)
        }
    })
}

fn array(items: &[Json]) -> Result<Array, String> {
    let mut array = items.iter().map(value).collect::<Result<Array, _>>()?;
    if !items.is_empty() && items.iter().all(Json::is_array) {
        for item in array.iter_mut() {
            item.decor_mut().set_prefix("\n    ");
        }
        array.set_trailing_comma(true);
        array.set_trailing("\n");
    }
    Ok(array)
}
