//! The keys of a value of the engine, in the record of a run.

use serde::Serialize;
use serde_json::{Map, Value as Json};

/// The fields of a struct, or of a variant of an enum, by name.
#[derive(Debug)]
pub(super) struct Fields(Map<String, Json>);

impl Fields {
    /// Returns no fields.
    pub(super) fn empty() -> Self {
        Self(Map::new())
    }

    /// Returns the fields of a struct.
    pub(super) fn of(value: &impl Serialize) -> Self {
        match json(value) {
            Json::Object(fields) => Self(fields),
            other => unreachable!("a struct is written as a table, not as {other}"),
        }
    }

    /// Returns the word of a variant under `tag`, and the variant's fields.
    pub(super) fn tagged(tag: &str, value: &impl Serialize) -> Self {
        Self::from_variant(tag, json(value))
    }

    fn from_variant(tag: &str, variant: Json) -> Self {
        let (name, fields) = match variant {
            Json::String(name) => (name, Map::new()),
            Json::Object(variant) => match variant.into_iter().next() {
                Some((name, Json::Object(fields))) => (name, fields),
                other => unreachable!("a variant has fields with names, not {other:?}"),
            },
            other => unreachable!("a variant is written with its name, not as {other}"),
        };
        Self(fields).with(tag, kebab(&name))
    }

    /// Puts a value under a key.
    pub(super) fn with(mut self, key: &str, value: impl Into<Json>) -> Self {
        self.0.insert(key.to_owned(), value.into());
        self
    }

    /// Removes keys that the record does not have, or has elsewhere.
    pub(super) fn without<const N: usize>(mut self, keys: [&str; N]) -> Self {
        for key in keys {
            self.0.remove(key);
        }
        self
    }

    /// Renames fields, each pair the engine's name and the record's. A missing field remains
    /// missing.
    pub(super) fn renamed<const N: usize>(mut self, names: [(&str, &str); N]) -> Self {
        for (from, to) in names {
            if let Some(value) = self.0.remove(from) {
                self.0.insert(to.to_owned(), value);
            }
        }
        self
    }

    /// Replaces the table under `key` by its fields, each after `prefix`; no effect where there is
    /// no such table.
    pub(super) fn spread(mut self, key: &str, prefix: &str) -> Self {
        if let Some(Json::Object(inner)) = self.0.remove(key) {
            let named = inner.into_iter();
            self.0.extend(named.map(|(name, value)| (format!("{prefix}{name}"), value)));
        }
        self
    }

    /// Replaces the variant under `key` by its word under `tag` and its fields.
    pub(super) fn spread_variant(mut self, key: &str, tag: &str) -> Self {
        if let Some(variant) = self.0.remove(key) {
            self.0.extend(Self::from_variant(tag, variant).0);
        }
        self
    }

    /// Writes the variant under `key` as a table with its word under `tag`; `null` is kept.
    pub(super) fn tag_inside(mut self, key: &str, tag: &str) -> Self {
        if let Some(value) = self.0.get_mut(key)
            && !value.is_null()
        {
            *value = Self::from_variant(tag, value.take()).into();
        }
        self
    }

    /// Writes the value under `key` in another form; `null` and a missing key are kept.
    pub(super) fn mapped(mut self, key: &str, write: impl FnOnce(&Json) -> Json) -> Self {
        if let Some(value) = self.0.get_mut(key)
            && !value.is_null()
        {
            *value = write(value);
        }
        self
    }

    /// Writes the variants under these keys as words.
    pub(super) fn words<const N: usize>(mut self, keys: [&str; N]) -> Self {
        for key in keys {
            if let Some(Json::String(name)) = self.0.get_mut(key) {
                *name = kebab(name);
            }
        }
        self
    }

    /// Returns the same keys with `null` values, where they are not used.
    pub(super) fn nulled(mut self) -> Self {
        self.0.values_mut().for_each(|value| *value = Json::Null);
        self
    }

    /// Returns all fields of both.
    pub(super) fn and(mut self, other: Self) -> Self {
        self.0.extend(other.0);
        self
    }
}

impl From<Fields> for Json {
    fn from(fields: Fields) -> Self {
        Self::Object(fields.0)
    }
}

/// Returns the word of a variant without fields.
pub(super) fn word(variant: &impl Serialize) -> Json {
    match json(variant) {
        Json::String(name) => kebab(&name).into(),
        other => unreachable!("a variant without fields is written as its name, not as {other}"),
    }
}

/// Returns a value as JSON; a number that is not finite is `null`.
pub(super) fn json(value: &impl Serialize) -> Json {
    serde_json::to_value(value).expect("numbers, words and lists")
}

/// Returns `MinimumCurvature` in the form of the case file: `minimum-curvature`.
fn kebab(name: &str) -> String {
    let mut word = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !word.is_empty() {
            word.push('-');
        }
        word.extend(letter.to_lowercase());
    }
    word
}
