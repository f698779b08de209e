//! Keys that a word chooses among: the tag, and for each of its words a group of keys.
//!
//! [`tagged!`](crate::tagged::tagged) generates from one list of groups the words of the tag, the
//! choice between the groups, and for each key the words that use it. All keys are in the same
//! table of the file, so that another word needs no further change: keys that only other words use
//! are read and checked, and have no effect.
//!
//! ```
//! use wholestring_config::prelude::*;
//!
//! /// The damping ratio from its keys.
//! trait Damping {
//!     fn ratio(&self) -> Option<f64>;
//! }
//!
//! keys! {
//!     /// Damping that is given.
//!     RatioKeys {
//!         /// Part of the critical damping.
//!         ratio: f64 = required(Number::up_to(1.0));
//!     }
//! }
//!
//! impl Variant for RatioKeys {
//!     const WORD: &'static str = "ratio";
//!     const MEANING: &'static str = "a part of the critical damping";
//! }
//!
//! impl Damping for RatioKeys {
//!     fn ratio(&self) -> Option<f64> {
//!         self.ratio.get().copied()
//!     }
//! }
//!
//! keys! {
//!     /// No damping.
//!     NoKeys {}
//! }
//!
//! impl Variant for NoKeys {
//!     const WORD: &'static str = "none";
//!     const MEANING: &'static str = "it rings on";
//! }
//!
//! impl Damping for NoKeys {
//!     fn ratio(&self) -> Option<f64> {
//!         Some(0.0)
//!     }
//! }
//!
//! tagged! {
//!     /// The damping and its numbers.
//!     DampingKeys as dyn Damping {
//!         /// It acts on every node.
//!         damping: Word = default(
//!             Choice { noun: "a damping", words: Word::WORDS },
//!             Word::None,
//!         );
//!         None => none: NoKeys;
//!         Ratio => ratio: RatioKeys;
//!     }
//! }
//!
//! table! {
//!     /// A beam.
//!     Beam in "[beam]" {
//!         ..damping: DampingKeys;
//!     }
//! }
//!
//! let beam = Beam::read(&Entries::default(), Span::default(), &mut Reader::default());
//! assert_eq!(beam.damping.chosen().and_then(Damping::ratio), Some(0.0));
//! assert_eq!(DampingKeys::users_of("ratio"), ["ratio"]);
//! let keys = &Beam::schema()["properties"];
//! assert_eq!(
//!     keys["damping"]["description"],
//!     "\"none\" (it rings on) or \"ratio\" (a part of the critical damping). It acts on every \
//!      node. Default: \"none\"."
//! );
//! assert_eq!(
//!     keys["ratio"]["description"],
//!     "Part of the critical damping. Required with damping = \"ratio\"."
//! );
//! ```

use crate::{
    rule::Written,
    table::{Here, Keys},
    table_schema::{TableSchema, Used, users_of},
};

/// The keys of a word of a tag.
pub trait Variant: Keys {
    /// The word.
    const WORD: &'static str;
    /// Its meaning, in a phrase.
    const MEANING: &'static str;
}

/// Adds the names that are missing so far.
pub fn add_names(names: &mut Vec<&'static str>, more: Vec<&'static str>) {
    for name in more {
        if !names.contains(&name) {
            names.push(name);
        }
    }
}

/// Adds the keys that are missing so far, with the words that use them.
pub fn add_written(written: &mut Vec<Written>, used: &[Used], more: Vec<Written>) {
    for key in more {
        if !written.iter().any(|known| known.name == key.name) {
            written.push(Written { used_with: users_of(used, key.name), ..key });
        }
    }
}

/// Describes the tag by its words and their meanings, and the keys of each word.
pub fn describe(
    (tag, doc): (&'static str, &str),
    meanings: &[(&str, &str)],
    used: Vec<Used>,
    table: &mut TableSchema,
    describe_tag: impl FnOnce(&str, &mut TableSchema),
    describe_keys: impl FnOnce(&mut TableSchema),
) {
    let phrases: Vec<String> =
        meanings.iter().map(|(word, meaning)| format!("\"{word}\" ({meaning})")).collect();
    let words = match phrases.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        one => one.concat(),
    };
    describe_tag(&format!("{words}. {}", doc.trim()), table);
    table.add_tagged(tag, used, describe_keys);
}

impl Here<'_> {
    /// The same for a group of some word, after other keys have been read.
    pub fn beside<'a>(&'a self, reported: &'a [&'static str], is_used: bool) -> Here<'a> {
        Here { reported, is_used: self.is_used && is_used, ..*self }
    }
}

/// Declares keys that a word chooses among: the enum of the words with `WORDS`, the struct of all
/// keys, its [`Keys`](crate::table::Keys), and `chosen`, the group of the word by the trait that
/// all groups implement. Groups before the words (`..group: Group;`) are read first; mistakes in
/// keys shared by several words are reported once.
#[doc(hidden)]
#[macro_export]
macro_rules! __tagged {
    (
        $(#[doc = $about:literal])+
        $name:ident as dyn $trait:path {
            $(#[doc = $doc:literal])+
            $tag:ident: $words:ident = $key:expr;
            $( ..$group:ident: $shared:ty; )*
            $( $variant:ident => $field:ident: $keys:ty; )+
        }
    ) => {
        #[doc = concat!("The words of `", stringify!($tag), "`.")]
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub(crate) enum $words {
            $( $variant, )+
        }

        impl $words {
            /// The words and their values.
            pub(crate) const WORDS: &[(&str, Self)] =
                &[$( (<$keys as $crate::tagged::Variant>::WORD, Self::$variant), )+];
        }

        $(#[doc = $about])+
        #[derive(Debug)]
        pub(crate) struct $name {
            $(#[doc = $doc])+
            pub(crate) $tag: $crate::table::Field<$words>,
            $( #[allow(dead_code)] pub(crate) $group: $shared, )*
            $( pub(crate) $field: $keys, )+
        }

        impl $name {
            /// Each word with its keys.
            fn used() -> Vec<$crate::table_schema::Used> {
                vec![$( (
                    <$keys as $crate::tagged::Variant>::WORD,
                    <$keys as $crate::table::Keys>::names(),
                ), )+]
            }

            /// The words that use a key.
            #[allow(dead_code)]
            pub(crate) fn users_of(name: &str) -> Vec<&'static str> {
                $crate::table_schema::users_of(&Self::used(), name)
            }

            /// The chosen word, or the default.
            #[allow(dead_code)]
            pub(crate) fn word(&self) -> Option<&'static str> {
                Some(match self.$tag.get()? {
                    $( $words::$variant => <$keys as $crate::tagged::Variant>::WORD, )+
                })
            }

            /// The keys of the chosen word, or of the default.
            pub(crate) fn chosen(&self) -> Option<&(dyn $trait + 'static)> {
                Some(match self.$tag.get()? {
                    $( $words::$variant => &self.$field, )+
                })
            }
        }

        impl $crate::table::Keys for $name {
            fn names() -> Vec<&'static str> {
                let mut names = vec![$crate::table::name(stringify!($tag))];
                $( $crate::tagged::add_names(
                    &mut names, <$shared as $crate::table::Keys>::names(),
                ); )*
                $( $crate::tagged::add_names(
                    &mut names, <$keys as $crate::table::Keys>::names(),
                ); )+
                names
            }

            fn read_keys(
                here: &$crate::table::Here<'_>,
                reader: &mut $crate::reader::Reader,
            ) -> Self {
                let mut reported = here.reported.to_vec();
                let $tag = $key.read($crate::table::name(stringify!($tag)), here, reader);
                $(
                    let $group = <$shared as $crate::table::Keys>::read_keys(
                        &here.beside(&reported, false), reader,
                    );
                    $crate::tagged::add_names(
                        &mut reported, <$shared as $crate::table::Keys>::names(),
                    );
                )*
                $(
                    let is_used = matches!($tag.get(), Some($words::$variant));
                    let $field = <$keys as $crate::table::Keys>::read_keys(
                        &here.beside(&reported, is_used), reader,
                    );
                    $crate::tagged::add_names(
                        &mut reported, <$keys as $crate::table::Keys>::names(),
                    );
                )+
                Self { $tag, $( $group, )* $( $field, )+ }
            }

            fn written_keys(&self) -> Vec<$crate::rule::Written> {
                let used = Self::used();
                let mut written: Vec<$crate::rule::Written> = $crate::rule::Written::key(
                    $crate::table::name(stringify!($tag)), self.$tag.place(), &[],
                ).into_iter().collect();
                $( $crate::tagged::add_written(
                    &mut written, &used, $crate::table::Keys::written_keys(&self.$group),
                ); )*
                $( $crate::tagged::add_written(
                    &mut written, &used, $crate::table::Keys::written_keys(&self.$field),
                ); )+
                written
            }

            fn describe_keys(table: &mut $crate::table_schema::TableSchema) {
                let tag = $crate::table::name(stringify!($tag));
                $crate::tagged::describe(
                    (tag, concat!($($doc),+)),
                    &[$( (
                        <$keys as $crate::tagged::Variant>::WORD,
                        <$keys as $crate::tagged::Variant>::MEANING,
                    ), )+],
                    Self::used(),
                    table,
                    |doc, table| $key.describe(tag, doc, table),
                    |table| {
                        $( <$shared as $crate::table::Keys>::describe_keys(table); )*
                        $( <$keys as $crate::table::Keys>::describe_keys(table); )+
                    },
                );
            }
        }
    };
}
pub use __tagged as tagged;

#[cfg(test)]
mod tests;
