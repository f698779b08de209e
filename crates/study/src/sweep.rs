//! `[[sweep]]`: the cases of a study.

use std::sync::Arc;

use serde_json::{Value as Json, json};
use wholestring_case::{Override, Quote, Variation};
use wholestring_config::prelude::*;

use crate::{
    file_name::FileName,
    selection::{Selection, SelectionRule, leaves},
};

table! {
    /// A case for every combination of given values.
    SweepTable in "[[sweep]]" {
        /// Name of the sweep in the study, and of its results folder.
        name: String = required(FileName);
        /// The case file, relative to the folder of the study.
        case: String = required(Text);
        /// Keys that are the same for all its cases, as in `--set`: dotted keys of the case file,
        /// and `friction`, `bit_depth`, `rpm` and `wob`.
        set: Vec<Override> = optional(Changes);
        /// Keys that are varied, and their values: one, a list, or a range "FROM..TO/STEP", as in
        /// `--vary`. Every combination is a case, the last key varying fastest. Default: one case.
        vary: Vec<Variation> = optional(Varied);
        /// Exceptions for some of its cases; if several apply, the last one takes effect.
        r#where: Vec<Spanned<WhereTable>> = optional(List::tables::<WhereTable>(
            "exceptions ([[sweep.where]])", 100,
        ));
    }
}

table! {
    /// An exception for some cases of a sweep.
    WhereTable in "[[sweep.where]]" {
        /// The cases: values of varied keys, single, listed or in a range such as "..1200 m" or
        /// "3300 m..".
        when: Selection = required(SelectionRule);
        /// The case file in these cases. Default: that of the sweep.
        case: String = optional(Text);
        /// Keys that are set in these cases, after those of the sweep.
        set: Vec<Override> = optional(Changes);
    }
}

/// A case for every combination of given values.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// Its name.
    pub name: String,
    /// The case file, relative to the folder of the study.
    pub case: String,
    /// Changes to all its cases.
    pub set: Vec<Override>,
    /// Keys that are varied.
    pub vary: Vec<Variation>,
    /// Exceptions for some of its cases.
    pub exceptions: Vec<Exception>,
}

/// An exception for some cases of a sweep.
#[derive(Debug, Clone)]
pub struct Exception {
    /// The cases.
    pub when: Selection,
    /// Their case file, if different.
    pub case: Option<String>,
    /// Their changes.
    pub set: Vec<Override>,
}

impl Sweep {
    /// The varied keys.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.vary.iter().map(|varied| varied.key.as_str())
    }
}

/// All sweeps; every exception must apply to at least one case.
pub(crate) fn build(tables: &[Spanned<SweepTable>], reader: &mut Reader) -> Option<Vec<Sweep>> {
    let mut sweeps: Vec<Sweep> = Vec::new();
    for Spanned { value: table, .. } in tables {
        let sweep = table.build()?;
        for exception in &sweep.exceptions {
            exception.when.check(&sweep.name, &sweep.vary, reader)?;
        }
        let name = table.name.at()?;
        let alike = |other: &Sweep| other.name.to_lowercase() == sweep.name.to_lowercase();
        if sweeps.iter().any(alike) {
            let message = format!("two sweeps are named `{}`", sweep.name);
            return Diagnostic::error(message)
                .at(name.place, "expected another name")
                .refuse(reader);
        }
        sweeps.push(sweep);
    }
    Some(sweeps)
}

impl SweepTable {
    fn build(&self) -> Option<Sweep> {
        let exceptions = self.r#where.optional()?.map_or(&[][..], |at| &at.value);
        Some(Sweep {
            name: self.name.get()?.clone(),
            case: self.case.get()?.clone(),
            set: changes(&self.set)?,
            vary: self.vary.optional()?.map_or_else(Vec::new, |at| at.value.clone()),
            exceptions: exceptions
                .iter()
                .map(|Spanned { value: table, .. }| {
                    Some(Exception {
                        when: table.when.get()?.clone(),
                        case: table.case.optional()?.map(|at| at.value.clone()),
                        set: changes(&table.set)?,
                    })
                })
                .collect::<Option<_>>()?,
        })
    }
}

fn changes(field: &Field<Vec<Override>>) -> Option<Vec<Override>> {
    Some(field.optional()?.map_or_else(Vec::new, |at| at.value.clone()))
}

/// A quotation of these places of the study.
fn quote(key: Span, value: Span, reader: &Reader) -> Quote {
    let source = &reader.sources[key.source];
    Quote {
        name: Arc::from(source.name.as_str()),
        text: Arc::from(source.text.as_str()),
        key: key.start..key.end,
        value: value.start..value.end,
        verbatim: true,
    }
}

/// `{ rpm = 70, wob = "6 tf" }`: keys of the case and their values.
struct Changes;

impl Rule for Changes {
    type Value = Vec<Override>;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Vec<Override>> {
        let Value::Table(entries) = &node.value else {
            reader.expected(node, "keys with values, such as { rpm = 70, wob = \"6 tf\" }");
            return None;
        };
        let mut changes = Vec::new();
        leaves(entries, "", &mut |key, place, value| {
            let quote = quote(place, value.place, reader);
            let written = reader.text_at(value.place);
            changes.push(Override::quoted(key, written, quote));
            true
        });
        Some(changes)
    }

    fn schema(&self) -> Json {
        json!({ "type": "object" })
    }
}

/// `{ friction = [0.1, 0.2], bit_depth = "300m..900m/300m" }`: keys of the case, each with its
/// values.
struct Varied;

impl Rule for Varied {
    type Value = Vec<Variation>;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Vec<Variation>> {
        let Value::Table(entries) = &node.value else {
            reader.expected(node, "keys with values, such as { friction = [0.1, 0.2] }");
            return None;
        };
        let mut variations = Vec::new();
        let valid = leaves(entries, "", &mut |key, key_place, node| {
            let items = match &node.value {
                Value::List(items) => items.as_slice(),
                _ => std::slice::from_ref(node),
            };
            if items.is_empty() {
                let message = format!("`{}` has no value", short(key));
                reader.report(Diagnostic::error(message).at(node.place, "expected at least one"));
                return false;
            }
            let mut variation = Variation { key: key.to_owned(), values: Vec::new() };
            let mut valid = true;
            for item in items {
                let written = reader.text_at(item.place).to_owned();
                let says = match &item.value {
                    Value::Text { text, .. } => text,
                    _ => &written,
                };
                let quote = quote(key_place, item.place, reader);
                valid &= variation.take([says, &written], quote, item.place, reader);
            }
            variations.push(variation);
            valid
        });
        valid.then_some(variations)
    }

    fn schema(&self) -> Json {
        json!({ "type": "object" })
    }
}
