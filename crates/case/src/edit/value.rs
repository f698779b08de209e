//! JSON as TOML.

use serde_json::{Map, Value as Json};
use toml_edit::{Array, InlineTable, Item, Table, Value};

/// Keys that say what a table is: they come first.
const SAYS_WHAT: [&str; 3] = ["component", "kind", "name"];

/// A value for a key: objects as tables under their own headings, lists of objects as lists of such
/// tables.
pub(super) fn item(of: &Json) -> Result<Item, String> {
    match of {
        Json::Object(of) => Ok(Item::Table(table_of(of)?)),
        Json::Array(items) if !items.is_empty() && items.iter().all(Json::is_object) => {
            let tables = items.iter().filter_map(Json::as_object).map(table_of);
            Ok(Item::ArrayOfTables(tables.collect::<Result<_, _>>()?))
        }
        other => Ok(Item::Value(value(other)?)),
    }
}

/// A table under its heading; what is in it stands on a line each.
pub(super) fn table_of(of: &Map<String, Json>) -> Result<Table, String> {
    let mut keys: Vec<&String> = of.keys().collect();
    keys.sort_by_key(|key| !SAYS_WHAT.contains(&key.as_str()));
    let pairs = keys.into_iter().map(|key| Ok::<_, String>((key, value(&of[key])?)));
    pairs.collect()
}

/// A value on one line; a list of lists has a line for each.
pub(super) fn value(of: &Json) -> Result<Value, String> {
    Ok(match of {
        Json::Null => return Err("TOML has no null; remove the key".to_owned()),
        Json::Bool(truth) => (*truth).into(),
        Json::String(text) => text.into(),
        Json::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(whole), _) => whole.into(),
            (None, Some(number)) => number.into(),
            (None, None) => return Err(format!("{number} is no number of TOML")),
        },
        Json::Array(items) => Value::Array(array(items)?),
        Json::Object(of) => {
            let pairs = of.iter().map(|(key, of)| Ok::<_, String>((key, value(of)?)));
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
