//! The JSON schema of the case file, from the same declarations that read it.

use std::sync::LazyLock;

use serde_json::{Value as Json, json};

use crate::{case::CaseTable, rule::Table, study::StudyTable};

/// JSON schema (draft 2020-12) of the case file: every key with its meaning, units, range and default.
///
/// It is made of the declarations that read the file, so that the two cannot disagree. What no schema
/// can say (relations between keys, what stands in the survey) is checked by [`crate::parse`].
pub fn schema() -> Json {
    let mut schema = TABLES.clone();
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!("wholestring case");
    schema
}

/// The same for the study file.
pub fn study_schema() -> Json {
    let mut schema = STUDY_TABLES.clone();
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!("wholestring study");
    schema
}

pub(crate) static STUDY_TABLES: LazyLock<Json> = LazyLock::new(StudyTable::schema);

pub(crate) static TABLES: LazyLock<Json> = LazyLock::new(CaseTable::schema);

/// The tables that have a key of this name, as messages call them.
pub(crate) fn homes_of(tables: &Json, name: &str) -> Vec<String> {
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
pub(crate) fn top_level() -> Vec<String> {
    let keys = TABLES["properties"].as_object();
    keys.map_or_else(Vec::new, |keys| keys.keys().cloned().collect())
}
