//! The JSON schema of the case file, from the same declarations that read it.

use std::sync::LazyLock;

use serde_json::{Value as Json, json};

use wholestring_config::rule::Table;

use crate::case::table::CaseTable;

/// JSON schema (draft 2020-12) of the case file: every key with its meaning, units, range and
/// default.
///
/// It is generated from the declarations that read the file, so that the two cannot disagree. Rules
/// that a schema cannot express (relations between keys, the content of the survey) are checked by
/// [`crate::parse`].
pub fn schema() -> Json {
    let mut schema = TABLES.clone();
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!("wholestring case");
    schema
}

pub(crate) static TABLES: LazyLock<Json> = LazyLock::new(CaseTable::schema);
