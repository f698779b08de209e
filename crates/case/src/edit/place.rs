//! The place of a dotted key, and changes there.

use serde_json::Value as Json;
use toml_edit::{Array, ArrayOfTables, DocumentMut, Item, Value};

use super::{
    lists,
    value::{self, table_of},
};

/// Reason of a failure.
type Why = String;

/// Returns the keys before the last, and the last.
fn parts(key: &str) -> Result<(Vec<&str>, &str), Why> {
    let mut parts: Vec<&str> = key.split('.').collect();
    if parts.iter().any(|part| part.trim().is_empty()) {
        return Err("it has an empty part".to_owned());
    }
    let last = parts.pop().unwrap_or_default();
    Ok((parts, last))
}

/// Returns the item that a part names within an item.
fn child<'a>(item: &'a mut Item, part: &str) -> Option<&'a mut Item> {
    match part.parse::<usize>() {
        Ok(index) if item.is_array() || item.is_array_of_tables() => item.get_mut(index),
        // Tested first, because indexing would create a missing key.
        _ if item.get(part).is_some() => item.get_mut(part),
        _ => None,
    }
}

/// Returns the item that the parts lead to.
fn find<'a>(document: &'a mut DocumentMut, parts: &[&str]) -> Result<&'a mut Item, Why> {
    let mut item = document.as_item_mut();
    for part in parts {
        item = child(item, part).ok_or_else(|| format!("there is no `{part}`"))?;
    }
    Ok(item)
}

/// Like [`find`], but creates missing tables.
fn find_or_make<'a>(document: &'a mut DocumentMut, parts: &[&str]) -> Result<&'a mut Item, Why> {
    let mut item = document.as_item_mut();
    for part in parts {
        if item.get(part).is_none() && part.parse::<usize>().is_err() {
            put(item, part, value::item(&Json::Object(Default::default()))?)?;
        }
        item = child(item, part).ok_or_else(|| format!("there is no `{part}`"))?;
    }
    Ok(item)
}

/// Puts a new key into a table.
fn put(item: &mut Item, key: &str, new: Item) -> Result<(), Why> {
    let Some(table) = item.as_table_like_mut() else {
        return Err(format!("the parent of `{key}` is not a table"));
    };
    table.insert(key, new);
    Ok(())
}

pub(super) fn set(document: &mut DocumentMut, key: &str, to: &Json) -> Result<(), Why> {
    let (before, last) = parts(key)?;
    let parent = find_or_make(document, &before)?;
    if let Some(old) = child(parent, last) {
        return change(old, to);
    }
    match parent.is_array() || parent.is_array_of_tables() {
        true => Err(format!("there is no `{last}`")),
        false => put(parent, last, value::item(to)?),
    }
}

/// Gives an item another value; comments after it are kept.
fn change(item: &mut Item, to: &Json) -> Result<(), Why> {
    if let (Some(table), Json::Object(object)) = (item.as_table_like_mut(), to) {
        let gone: Vec<String> = table
            .iter()
            .map(|(key, _)| key.to_owned())
            .filter(|key| !object.contains_key(key))
            .collect();
        for key in gone {
            table.remove(&key);
        }
        for (key, to) in object {
            match table.get_mut(key) {
                Some(old) => change(old, to)?,
                None => {
                    table.insert(key, value::item(to)?);
                }
            }
        }
        return Ok(());
    }
    let new = value::item(to)?;
    if item.is_array_of_tables() || item.is_table() {
        *item = new;
        return Ok(());
    }
    let decor = item.as_value().map(|old| old.decor().clone());
    *item = match new {
        Item::Table(table) => Item::Value(Value::InlineTable(table.into_inline_table())),
        Item::ArrayOfTables(tables) => Item::Value(Value::Array(tables.into_array())),
        other => other,
    };
    if let (Some(decor), Some(new)) = (decor, item.as_value_mut()) {
        *new.decor_mut() = decor;
    }
    Ok(())
}

pub(super) fn remove(document: &mut DocumentMut, key: &str) -> Result<(), Why> {
    let (before, last) = parts(key)?;
    let parent = find(document, &before)?;
    let missing = || format!("there is no `{last}`");
    if let Some(table) = parent.as_table_like_mut() {
        return table.remove(last).map(drop).ok_or_else(missing);
    }
    let index: usize = last.parse().map_err(|_| missing())?;
    if index >= length(parent).ok_or_else(missing)? {
        return Err(missing());
    }
    if let Some(list) = parent.as_array_of_tables_mut() {
        list.remove(index);
    } else if let Some(list) = parent.as_array_mut() {
        lists::change_array(list, |items| drop(items.remove(index)));
    }
    // A list of tables that becomes empty is removed, because it would not be written.
    if length(parent) == Some(0) && parent.is_array_of_tables() {
        *parent = Item::None;
    }
    Ok(())
}

pub(super) fn insert(
    document: &mut DocumentMut,
    key: &str,
    at: usize,
    to: &Json,
) -> Result<(), Why> {
    let (before, last) = parts(key)?;
    let parent = find_or_make(document, &before)?;
    if child(parent, last).is_none() {
        let empty = match to {
            Json::Object(_) if parent.is_table() => Item::ArrayOfTables(ArrayOfTables::new()),
            _ => Item::Value(Value::Array(Array::new())),
        };
        put(parent, last, empty)?;
    }
    let list = child(parent, last).ok_or("it is not a list")?;
    let length = length(list).ok_or("it is not a list")?;
    if at > length {
        return Err(format!("it has {length} items: there is no place {at}"));
    }
    if let Some(list) = list.as_array_of_tables_mut() {
        let Json::Object(object) = to else {
            return Err("its items are tables".to_owned());
        };
        lists::insert_table(list, at, table_of(object)?);
    } else if let Some(list) = list.as_array_mut() {
        let new = value::value(to)?;
        lists::change_array(list, |items| items.insert(at, lists::Element::new(new)));
    }
    Ok(())
}

pub(super) fn moved(
    document: &mut DocumentMut,
    key: &str,
    from: usize,
    to: usize,
) -> Result<(), Why> {
    let (mut all, last) = parts(key)?;
    all.push(last);
    let list = find(document, &all)?;
    let length = length(list).ok_or("it is not a list")?;
    if from.max(to) >= length {
        return Err(format!("it has {length} items: there is no place {}", from.max(to)));
    }
    if let Some(list) = list.as_array_of_tables_mut() {
        lists::move_table(list, from, to);
    } else if let Some(list) = list.as_array_mut() {
        lists::change_array(list, |items| {
            let item = items.remove(from);
            items.insert(to, item);
        });
    }
    Ok(())
}

fn length(item: &Item) -> Option<usize> {
    let of_tables = item.as_array_of_tables().map(ArrayOfTables::len);
    of_tables.or_else(|| item.as_array().map(Array::len))
}
