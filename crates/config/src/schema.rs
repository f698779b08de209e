//! Queries about the keys of a file's tables, from its schema.

use serde_json::Value as Json;

/// The tables that have a key of this name, by their names in messages.
pub fn homes_of(tables: &Json, name: &str) -> Vec<String> {
    fn visit(schema: &Json, name: &str, homes: &mut Vec<String>) {
        match schema {
            Json::Object(object) => {
                let title = object.get("title").and_then(Json::as_str);
                if let (Some(title), Some(Json::Object(keys))) = (title, object.get("properties"))
                    && keys.contains_key(name)
                    && !homes.iter().any(|home| home == title)
                {
                    homes.push(title.to_owned());
                }
                object.values().for_each(|value| visit(value, name, homes));
            }
            Json::Array(items) => items.iter().for_each(|value| visit(value, name, homes)),
            _ => {}
        }
    }
    let mut homes = Vec::new();
    visit(tables, name, &mut homes);
    homes
}

/// The keys outside all tables, and the tables.
pub fn top_level(tables: &Json) -> Vec<String> {
    let keys = tables["properties"].as_object();
    keys.map_or_else(Vec::new, |keys| keys.keys().cloned().collect())
}
