//! The schema of a table under construction.

use serde_json::{Map, Value as Json, json};

/// A word of a tag, and the keys that it uses.
pub type Used = (&'static str, Vec<&'static str>);

/// The words that use a key.
pub fn users_of(used: &[Used], name: &str) -> Vec<&'static str> {
    used.iter().filter(|(_, keys)| keys.contains(&name)).map(|(word, _)| *word).collect()
}

/// The schema of a table under construction.
#[derive(Default)]
pub struct TableSchema {
    properties: Map<String, Json>,
    /// Their names in the order of the declaration, which keeps related keys together.
    order: Vec<String>,
    required: Vec<String>,
    /// A key that chooses among words, and the keys that each word uses.
    tag: Option<(&'static str, Vec<Used>)>,
}

impl TableSchema {
    /// The schema of the whole table.
    pub fn finish(self, heading: &str, doc: &str) -> Json {
        let mut schema = json!({
            "type": "object",
            "title": heading,
            "description": doc.trim(),
            "properties": self.properties,
            "x-order": self.order,
            "additionalProperties": false,
        });
        if !self.required.is_empty() {
            schema["required"] = json!(self.required);
        }
        schema
    }

    /// Adds a key. A group that several words use is described identically for each.
    pub(crate) fn add(&mut self, name: &str, schema: Json, is_required: bool) {
        if is_required {
            self.required.push(name.to_owned());
        }
        let known = self.properties.get(name);
        debug_assert!(known.is_none_or(|known| *known == schema), "`{name}` is declared twice");
        if known.is_none() {
            self.order.push(name.to_owned());
        }
        self.properties.insert(name.to_owned(), schema);
    }

    /// Adds keys that the words of `tag` use, each word those listed with it.
    pub(crate) fn add_tagged(
        &mut self,
        tag: &'static str,
        used: Vec<Used>,
        describe: impl FnOnce(&mut Self),
    ) {
        let outer = self.tag.replace((tag, used));
        describe(self);
        self.tag = outer;
    }

    /// The tag and its words that use a key; none if no word does.
    pub(crate) fn users_of(&self, name: &str) -> Option<(&'static str, Vec<&'static str>)> {
        let (tag, used) = self.tag.as_ref()?;
        let users = users_of(used, name);
        (!users.is_empty()).then_some((*tag, users))
    }
}
