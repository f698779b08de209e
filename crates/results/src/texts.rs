//! Texts of a summary that can be read in other units than those of its case.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use wholestring_judge::{Check, Wording};
use wholestring_units::UnitSet;

/// Texts of a summary with their quantities, by the text in the units of the summary. Texts without
/// a quantity are the same in all units and have no entry.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Texts(BTreeMap<String, Wording>);

impl Texts {
    /// Whether no text has a quantity.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns a text with marked quantities ([`Quantity`](wholestring_judge::Quantity)) in the
    /// units of the summary, and records its quantities.
    pub fn worded(&mut self, text: impl Into<Wording>, units: UnitSet) -> String {
        let wording = text.into();
        let words = wording.in_units(units);
        if !wording.is_plain() {
            self.0.insert(words.clone(), wording);
        }
        words
    }

    /// Records the sentence of a check.
    pub fn record(&mut self, check: &Check) {
        if !check.wording.is_empty() {
            self.0.insert(check.sentence.clone(), check.wording.clone());
        }
    }

    /// Adds the texts of another part of the summary.
    pub fn merge(&mut self, other: Self) {
        self.0.extend(other.0);
    }

    /// A text of the summary in these units; unchanged where its quantities are not known.
    pub fn in_units(&self, text: &str, units: UnitSet) -> String {
        self.0.get(text).map_or_else(|| text.to_owned(), |wording| wording.in_units(units))
    }
}
