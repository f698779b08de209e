//! Declares a table of the case file once: the struct, its reader, its names and its schema.

use serde_json::json;

use crate::{
    diagnostic::Diagnostic,
    names::any_of,
    node::Entries,
    reader::Reader,
    rule::{Rule, Spanned, Written},
    source::Span,
    table_schema::TableSchema,
};

/// Keys of a table: all of them, or a separately declared group. [`keys!`](crate::table::keys)
/// declares such a group, and `..group: Group;` puts it into a table or another group.
pub trait Keys: Sized {
    /// Their names, in the order of the declaration.
    fn names() -> Vec<&'static str>;
    /// Reads them; mistakes are added to the reader's diagnostics.
    fn read_keys(here: &Here<'_>, reader: &mut Reader) -> Self;
    /// Those that are present in the file.
    fn written_keys(&self) -> Vec<Written>;
    /// Adds them to the schema of their table.
    fn describe_keys(table: &mut TableSchema);
}

/// Result of reading a key.
#[derive(Debug, Clone, PartialEq)]
pub enum Field<T> {
    /// It is missing in the file, which is permitted or has been reported.
    Absent,
    /// Its value is invalid, which has been reported.
    Bad,
    /// It is present in the file.
    Given(Spanned<T>),
    /// It is missing in the file; this is the default. The place is that of its table.
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

    /// The value and its place, if it is present in the file.
    pub fn given(&self) -> Option<&Spanned<T>> {
        match self {
            Self::Given(at) => Some(at),
            _ => None,
        }
    }

    /// The place of the value, if it is present in the file.
    pub fn place(&self) -> Option<Span> {
        self.given().map(|at| at.place)
    }

    /// `None` if the value is invalid, `Some(None)` if it is missing.
    pub fn optional(&self) -> Option<Option<&Spanned<T>>> {
        match self {
            Self::Bad => None,
            _ => Some(self.at()),
        }
    }
}

impl Field<String> {
    /// The text, an empty one if it is missing; none if it is invalid.
    pub fn text(&self) -> Option<String> {
        let value = self.optional()?;
        Some(value.map_or_else(String::new, |at| at.value.clone()))
    }
}

/// Treatment of a missing key.
pub enum Need<T> {
    /// It is required.
    Required,
    /// Required, unless this other key is present.
    RequiredUnless(&'static str),
    /// It may be omitted.
    Optional,
    /// This value replaces it.
    Default(T),
}

/// A key: its rule and whether it is required.
pub struct Key<R: Rule> {
    /// The rule of its value.
    pub rule: R,
    /// Treatment if it is missing in the file.
    pub need: Need<R::Value>,
    /// The words of the table's choice with which it has an effect; empty for all.
    pub used_with: &'static [&'static str],
}

/// A required key.
pub fn required<R: Rule>(rule: R) -> Key<R> {
    Key { rule, need: Need::Required, used_with: &[] }
}

/// A key that is required if `other` is missing.
pub fn required_unless<R: Rule>(other: &'static str, rule: R) -> Key<R> {
    Key { rule, need: Need::RequiredUnless(other), used_with: &[] }
}

/// An optional key.
pub fn optional<R: Rule>(rule: R) -> Key<R> {
    Key { rule, need: Need::Optional, used_with: &[] }
}

/// A key with a default.
pub fn default<R: Rule>(rule: R, value: R::Value) -> Key<R> {
    Key { rule, need: Need::Default(value), used_with: &[] }
}

/// The table being read.
#[derive(Debug, Clone, Copy)]
pub struct Here<'a> {
    /// Its keys and values.
    pub entries: &'a Entries,
    /// Its place.
    pub place: Span,
    /// Its name in messages.
    pub heading: &'static str,
    /// The probable names of misspelt keys, which are not reported as missing as well.
    pub meant: &'a [&'static str],
    /// Keys that another group of the table has read, whose mistakes have been reported.
    pub reported: &'a [&'static str],
    /// Whether missing required keys are reported: not in a group that nothing uses.
    pub is_used: bool,
}

impl<R: Rule> Key<R> {
    /// The same, but it has an effect only with these words of the table's choice: of a law, of a
    /// control.
    pub fn used_with(self, words: &'static [&'static str]) -> Self {
        Self { used_with: words, ..self }
    }

    /// Reads the key, or returns its replacement.
    pub fn read(self, name: &'static str, here: &Here<'_>, reader: &mut Reader) -> Field<R::Value> {
        if here.reported.contains(&name) && here.entries.get(name).is_some() {
            reader.muted(|reader| self.read_or_default(name, here, reader))
        } else {
            self.read_or_default(name, here, reader)
        }
    }

    fn read_or_default(
        self,
        name: &'static str,
        here: &Here<'_>,
        reader: &mut Reader,
    ) -> Field<R::Value> {
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
            Need::Required | Need::RequiredUnless(_) if !here.is_used => Field::Absent,
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
        // The whole file is not underlined.
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
        let users = table.users_of(name);
        let is_required = matches!(self.need, Need::Required);
        if let Some((tag, words)) = &users {
            let how = if is_required { "Required" } else { "Used" };
            doc.push_str(&format!(" {how} with {tag} = {}.", any_of(words)));
        }
        if let Need::Default(value) = &self.need {
            let default = self.rule.json(value);
            doc.push_str(&format!(" Default: {}.", self.rule.written(&default)));
            schema["default"] = default;
        }
        schema["description"] = json!(doc);
        table.add(name, schema, is_required && users.is_none());
    }
}

/// The name of a field in the case file: `static` is reserved in Rust.
pub fn name(field: &'static str) -> &'static str {
    field.trim_start_matches("r#")
}

/// Declares a group of keys of a table, or of several tables: its struct and its [`Keys`]. The doc
/// comments become the descriptions of the schema. `..group: Group;` inserts another group at that
/// position.
#[doc(hidden)]
#[macro_export]
macro_rules! __keys {
    (
        $(#[doc = $about:literal])+
        $name:ident {
            $( $(#[doc = $doc:literal])+ $field:ident: $type:ty = $key:expr; )*
            $(
                ..$group:ident: $keys:ty;
                $( $(#[doc = $more_doc:literal])+ $more:ident: $more_type:ty = $more_key:expr; )*
            )*
        }
    ) => {
        $(#[doc = $about])+
        #[derive(Debug)]
        pub(crate) struct $name {
            $( $(#[doc = $doc])+ pub(crate) $field: $crate::table::Field<$type>, )*
            $(
                pub(crate) $group: $keys,
                $( $(#[doc = $more_doc])+ pub(crate) $more: $crate::table::Field<$more_type>, )*
            )*
        }

        impl $crate::table::Keys for $name {
            fn names() -> Vec<&'static str> {
                let own: &[&'static str] = &[$( $crate::table::name(stringify!($field)), )*];
                #[allow(unused_mut)]
                let mut names = own.to_vec();
                $(
                    names.extend(<$keys as $crate::table::Keys>::names());
                    $( names.push($crate::table::name(stringify!($more))); )*
                )*
                names
            }

            fn read_keys(
                here: &$crate::table::Here<'_>,
                reader: &mut $crate::reader::Reader,
            ) -> Self {
                let _ = (&here, &reader);
                Self {
                    $( $field: $key.read($crate::table::name(stringify!($field)), here, reader), )*
                    $(
                        $group: <$keys as $crate::table::Keys>::read_keys(here, reader),
                        $( $more: $more_key.read(
                            $crate::table::name(stringify!($more)), here, reader,
                        ), )*
                    )*
                }
            }

            fn written_keys(&self) -> Vec<$crate::rule::Written> {
                #[allow(unused_mut)]
                let mut written = Vec::new();
                $( written.extend($crate::rule::Written::key(
                    $crate::table::name(stringify!($field)), self.$field.place(), $key.used_with,
                )); )*
                $(
                    written.extend($crate::table::Keys::written_keys(&self.$group));
                    $( written.extend($crate::rule::Written::key(
                        $crate::table::name(stringify!($more)),
                        self.$more.place(),
                        $more_key.used_with,
                    )); )*
                )*
                written
            }

            fn describe_keys(table: &mut $crate::table_schema::TableSchema) {
                let _ = &table;
                $( $key.describe(
                    $crate::table::name(stringify!($field)), concat!($($doc),+), table,
                ); )*
                $(
                    <$keys as $crate::table::Keys>::describe_keys(table);
                    $( $more_key.describe(
                        $crate::table::name(stringify!($more)), concat!($($more_doc),+), table,
                    ); )*
                )*
            }
        }
    };
}
pub use __keys as keys;

/// Declares a table of the case file: its keys as [`keys!`](crate::table::keys) does, and their
/// heading.
#[doc(hidden)]
#[macro_export]
macro_rules! __table {
    (
        $(#[doc = $about:literal])+
        $name:ident in $heading:literal { $($keys:tt)+ }
    ) => {
        $crate::table::keys! { $(#[doc = $about])+ $name { $($keys)+ } }

        impl $crate::rule::Table for $name {
            const HEADING: &'static str = $heading;

            fn read(
                entries: &$crate::node::Entries,
                place: $crate::source::Span,
                reader: &mut $crate::reader::Reader,
            ) -> Self {
                let names = <Self as $crate::table::Keys>::names();
                let meant = reader.check_names(entries, &names, $heading);
                let here = $crate::table::Here {
                    entries,
                    place,
                    heading: $heading,
                    meant: &meant,
                    reported: &[],
                    is_used: true,
                };
                <Self as $crate::table::Keys>::read_keys(&here, reader)
            }

            fn written(&self) -> Vec<$crate::rule::Written> {
                $crate::table::Keys::written_keys(self)
            }

            fn schema() -> $crate::Json {
                let mut table = $crate::table_schema::TableSchema::default();
                <Self as $crate::table::Keys>::describe_keys(&mut table);
                table.finish($heading, concat!($($about),+))
            }
        }
    };
}
pub use __table as table;
