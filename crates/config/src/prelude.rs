//! Imports for the declaration of tables.

pub use crate::{
    diagnostic::Diagnostic,
    names::{any_of, nearest, short},
    node::{Entries, Node, Value},
    number::{Count, Number, Whole},
    quantity::Quantity,
    range::Range,
    reader::{Reader, shown},
    rule::{Choice, List, Prose, Rule, Section, Spanned, Table, Text, Written, once_each, word_of},
    source::{COMMAND_LINE, Files, Span},
    table::{Field, default, keys, optional, required, table},
    tagged::{Variant, tagged},
};
pub use wholestring_units::{Dimension, number_text};
