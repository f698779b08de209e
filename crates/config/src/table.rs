//! Declares a table of the case file once: the struct, its reader, its names and its schema.

use serde_json::{Map, Value as Json, json};

use crate::{
    diagnostic::Diagnostic,
    node::Entries,
    reader::Reader,
    rule::{Rule, Spanned},
    source::Span,
};

/// What became of a key.
#[derive(Debug, Clone, PartialEq)]
pub enum Field<T> {
    /// It does not stand in the file, and that is no mistake or has been reported.
    Absent,
    /// What stands in the file is wrong, which has been reported.
    Bad,
    /// It stands in the file.
    Given(Spanned<T>),
    /// It does not stand in the file; this is the default. The place is that of its table.
    Default(Spanned<T>),
}

impl<T> Field<T> {
    /// The value, given or default.
    pub fn get(&self) -> Option<&T> {
        self.at().map(|at| &at.value)
    }

    /// The value and its place, given or default.
    pub fn at(&self) -> Option<&Spanned<T>> {
        match self {
            Self::Given(at) | Self::Default(at) => Some(at),
            Self::Absent | Self::Bad => None,
        }
    }

    /// The value and its place, if it stands in the file.
    pub fn given(&self) -> Option<&Spanned<T>> {
        match self {
            Self::Given(at) => Some(at),
            _ => None,
        }
    }

    /// Where the value stands, if it stands in the file.
    pub fn place(&self) -> Option<Span> {
        self.given().map(|at| at.place)
    }

    /// `None` where the value is wrong, `Some(None)` where there is none.
    pub fn optional(&self) -> Option<Option<&Spanned<T>>> {
        match self {
            Self::Bad => None,
            _ => Some(self.at()),
        }
    }
}

impl Field<String> {
    /// The text, an empty one where there is none; nothing where it is wrong.
    pub fn text(&self) -> Option<String> {
        let given = self.optional()?;
        Some(given.map_or_else(String::new, |at| at.value.clone()))
    }
}

/// What happens where a key does not stand in the file.
pub enum Need<T> {
    /// It must stand there.
    Required,
    /// Required, but not beside this other key.
    RequiredUnless(&'static str),
    /// It may be left out.
    Optional,
    /// This is taken in its place.
    Default(T),
}

/// A key: its rule and whether it must be there.
pub struct Key<R: Rule> {
    /// What a value must look like.
    pub rule: R,
    /// What happens where it does not stand in the file.
    pub need: Need<R::Value>,
    /// The words of the table's choice with which it has an effect; all, where none is listed.
    pub used_with: &'static [&'static str],
}

/// A key that must be there.
pub fn required<R: Rule>(rule: R) -> Key<R> {
    Key { rule, need: Need::Required, used_with: &[] }
}

/// A key that must be there where `other` is not.
pub fn required_unless<R: Rule>(other: &'static str, rule: R) -> Key<R> {
    Key { rule, need: Need::RequiredUnless(other), used_with: &[] }
}

/// A key that may be left out.
pub fn optional<R: Rule>(rule: R) -> Key<R> {
    Key { rule, need: Need::Optional, used_with: &[] }
}

/// A key that has a default.
pub fn default<R: Rule>(rule: R, value: R::Value) -> Key<R> {
    Key { rule, need: Need::Default(value), used_with: &[] }
}

/// The table that is being read.
pub struct Here<'a> {
    /// Its keys and values.
    pub entries: &'a Entries,
    /// Where it stands.
    pub place: Span,
    /// How messages call it.
    pub heading: &'static str,
    /// The keys that misspelt ones were probably meant to be: they are not missed as well.
    pub meant: &'a [&'static str],
}

impl<R: Rule> Key<R> {
    /// The same, but it has an effect with these words of the table's choice only: of a law, of a
    /// control.
    pub fn used_with(self, words: &'static [&'static str]) -> Self {
        Self { used_with: words, ..self }
    }

    /// Reads the key, or takes what there is in its place.
    pub fn read(self, name: &'static str, here: &Here<'_>, reader: &mut Reader) -> Field<R::Value> {
        let place = here.place;
        reader.key = name;
        if let Some(node) = here.entries.get(name) {
            return match self.rule.read(node, reader) {
                Some(value) => Field::Given(Spanned { value, place: node.place }),
                None => Field::Bad,
            };
        }
        match self.need {
            Need::Default(value) => Field::Default(Spanned { value, place }),
            Need::RequiredUnless(other) if here.entries.get(other).is_some() => Field::Absent,
            Need::Required | Need::RequiredUnless(_) => {
                let unless = match self.need {
                    Need::RequiredUnless(other) => other,
                    _ => name,
                };
                if !here.meant.contains(&name) && !here.meant.contains(&unless) {
                    reader.report(self.missing(name, here));
                }
                Field::Bad
            }
            Need::Optional => match self.rule.absent(place, reader) {
                Some(value) => Field::Default(Spanned { value, place }),
                None => Field::Absent,
            },
        }
    }

    fn missing(&self, name: &str, here: &Here<'_>) -> Diagnostic {
        let called = match self.rule.heading() {
            Some(table) => table.to_owned(),
            None => format!("`{name}`"),
        };
        let mut diagnostic = Diagnostic::error(format!("{} lacks {called}", here.heading));
        // The whole file is not worth underlining.
        if here.place.end > here.place.start {
            diagnostic = diagnostic.at(here.place, format!("{called} is missing"));
        }
        if let Some(example) = self.rule.example() {
            diagnostic = diagnostic.help(format!("such as {name} = {example}"));
        }
        match self.need {
            Need::RequiredUnless(other) => diagnostic.help(format!("or give `{other}` instead")),
            _ => diagnostic,
        }
    }

    /// Adds the key to the schema of its table.
    pub fn describe(self, name: &str, doc: &str, table: &mut TableSchema) {
        let mut schema = self.rule.schema();
        let mut doc = doc.trim().to_owned();
        match &self.need {
            Need::Required => table.required.push(name.to_owned()),
            Need::Default(value) => {
                let default = self.rule.json(value);
                doc.push_str(&format!(" Default: {}.", self.rule.written(&default)));
                schema["default"] = default;
            }
            Need::Optional | Need::RequiredUnless(_) => {}
        }
        schema["description"] = json!(doc);
        table.properties.insert(name.to_owned(), schema);
    }
}

/// The schema of a table as it is being made.
#[derive(Default)]
pub struct TableSchema {
    properties: Map<String, Json>,
    required: Vec<String>,
}

impl TableSchema {
    /// The schema of the whole table.
    pub fn finish(self, heading: &str, doc: &str) -> Json {
        let mut schema = json!({
            "type": "object",
            "title": heading,
            "description": doc.trim(),
            "properties": self.properties,
            "additionalProperties": false,
        });
        if !self.required.is_empty() {
            schema["required"] = json!(self.required);
        }
        schema
    }
}

/// The name of a field as the case file has it: `static` is a word of Rust's own.
pub fn name(field: &'static str) -> &'static str {
    field.trim_start_matches("r#")
}

/// Declares a table of the case file. The doc comments become the descriptions of the schema.
#[doc(hidden)]
#[macro_export]
macro_rules! __table {
    (
        $(#[doc = $about:literal])+
        $name:ident in $heading:literal {
            $( $(#[doc = $doc:literal])+ $field:ident: $type:ty = $key:expr; )+
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Debug)]
        pub(crate) struct $name {
            $( $(#[doc = $doc])+ pub(crate) $field: $crate::table::Field<$type>, )+
        }

        impl $crate::rule::Table for $name {
            const HEADING: &'static str = $heading;

            fn read(
                entries: &$crate::node::Entries,
                place: $crate::source::Span,
                reader: &mut $crate::reader::Reader,
            ) -> Self {
                let names = [$($crate::table::name(stringify!($field))),+];
                let meant = reader.check_names(entries, &names, $heading);
                let here = $crate::table::Here { entries, place, heading: $heading, meant: &meant };
                Self {
                    $( $field: $key.read($crate::table::name(stringify!($field)), &here, reader), )+
                }
            }

            fn written(&self) -> Vec<$crate::rule::Written> {
                let mut written = Vec::new();
                $( if let Some(place) = self.$field.place() {
                    written.push($crate::rule::Written {
                        name: $crate::table::name(stringify!($field)),
                        place,
                        used_with: $key.used_with,
                    });
                } )+
                written
            }

            fn schema() -> $crate::Json {
                let mut table = $crate::table::TableSchema::default();
                $( $key.describe($crate::table::name(stringify!($field)), concat!($($doc),+), &mut table); )+
                table.finish($heading, concat!($($about),+))
            }
        }
    };
}
pub use __table as table;
