//! Uncertain numbers of a case, and the samples that are drawn of them.

pub(crate) mod check;
pub(crate) mod table;

use serde::{Serialize, Serializer};
use wholestring_config::{
    node::{Key, parse_value},
    prelude::*,
};
use wholestring_plan::{
    Statics,
    uncertainty::{Distribution, latin_hypercube},
};
use wholestring_units::significant;

use crate::edit::overrides::put;

/// Uncertain inputs and their sampling.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Uncertain {
    /// The numbers, each independent of the others.
    pub inputs: Vec<UncertainInput>,
    /// Number of samples.
    pub samples: usize,
    /// Seed of the draw.
    pub seed: u64,
    /// The model of the samples.
    pub model: Statics,
}

/// An uncertain number of the case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UncertainInput {
    /// Dotted or short key of the case.
    pub key: String,
    /// Its distribution, in `unit`; of a choice, the distribution of the indices of its values.
    #[serde(serialize_with = "as_text")]
    pub distribution: Distribution,
    /// Its unit as written; empty for a bare number.
    pub unit: String,
    /// Whether a blank precedes the unit.
    #[serde(skip)]
    pub(crate) apart: bool,
    /// The values of a choice, in the form of the case.
    pub values: Vec<String>,
    /// Places of key and distribution.
    #[serde(skip)]
    pub(crate) key_place: Span,
    #[serde(skip)]
    pub(crate) place: Span,
}

/// Serialises a distribution as text, because JSON has no infinite numbers for its ends.
fn as_text<S: Serializer>(distribution: &Distribution, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&format_args!("{distribution:?}"))
}

impl Uncertain {
    /// Returns a row for each sample, with a value of each input.
    pub fn points(&self) -> Vec<Vec<f64>> {
        latin_hypercube(&self.distributions(), self.samples, self.seed)
    }

    /// Returns the distribution of each input.
    pub fn distributions(&self) -> Vec<Distribution> {
        self.inputs.iter().map(|input| input.distribution).collect()
    }

    /// Sets a value of each input in the tree of a case, which is then certain.
    pub(crate) fn put(&self, point: &[f64], root: &mut Entries, reader: &mut Reader) {
        make_certain(root);
        for (input, value) in self.inputs.iter().zip(point) {
            put(root, &input.key, &input.node(*value), input.key_place, reader);
        }
    }
}

/// Removes the uncertain numbers from the tree of a case.
pub(crate) fn make_certain(root: &mut Entries) {
    if let Some(Node { value: Value::Table(plan), .. }) = root.get_mut("plan") {
        plan.0.retain(|(Key { name, .. }, _)| name != "uncertain");
    }
}

impl UncertainInput {
    /// Returns a value in the form of the case: `0.3`, `1.2 sg`, one of a choice.
    pub fn written(&self, value: f64) -> String {
        if !self.values.is_empty() {
            return self.values.get(value as usize).cloned().unwrap_or_default();
        }
        let blank = if self.apart { " " } else { "" };
        format!("{value}{blank}{}", self.unit)
    }

    /// Returns the same in six digits, for display.
    pub(crate) fn rounded(&self, value: f64) -> String {
        match self.values.is_empty() {
            true => self.written(significant(value, 6)),
            false => self.written(value),
        }
    }

    /// Returns a value in the form of a table: of a choice among numbers the number itself.
    pub fn number(&self, value: f64) -> f64 {
        match self.values.is_empty() {
            true => value,
            false => self.written(value).parse().unwrap_or(f64::NAN),
        }
    }

    /// Returns the same as a node of the tree of a case.
    pub(crate) fn node(&self, value: f64) -> Node {
        let Self { place, .. } = *self;
        let text = self.written(value);
        let value = match parse_value(&text, place.source, place.start) {
            Ok(Node { value: found @ Value::Number { .. }, .. }) => found,
            _ => Value::Text { text, verbatim_from: None },
        };
        Node { place, value }
    }

    /// Returns the ends of the range of all or nearly all values, in its unit; `None` for a choice.
    pub(crate) fn ends(&self) -> Option<[f64; 2]> {
        match self.distribution {
            Distribution::Uniform { from, to } | Distribution::Triangular { from, to, .. } => {
                Some([from, to])
            }
            Distribution::Normal { mean, std } => Some([mean - MOST * std, mean + MOST * std]),
            Distribution::TruncatedNormal { mean, std, from, to } => {
                Some([from.max(mean - MOST * std), to.min(mean + MOST * std)])
            }
            Distribution::LogNormal { median, factor } => {
                Some([median / libm::pow(factor, MOST), median * libm::pow(factor, MOST)])
            }
            Distribution::Choice { .. } => None,
        }
    }

    /// Returns a description of the distribution, for display.
    pub fn said(&self) -> String {
        let with = |value: f64| {
            let blank = if self.apart { " " } else { "" };
            format!("{}{blank}{}", number_text(value), self.unit)
        };
        match self.distribution {
            Distribution::Uniform { from, to } => format!("even, {} to {}", with(from), with(to)),
            Distribution::Triangular { from, mode, to } => {
                format!("triangular, {} to {}, likeliest {}", with(from), with(to), with(mode))
            }
            Distribution::Normal { mean, std } => format!("normal, {} ± {}", with(mean), with(std)),
            Distribution::TruncatedNormal { mean, std, from, to } => {
                let cut = match (from.is_finite(), to.is_finite()) {
                    (true, true) => format!("{} to {}", with(from), with(to)),
                    (true, false) => format!("from {}", with(from)),
                    _ => format!("up to {}", with(to)),
                };
                format!("normal, {} ± {}, {cut}", with(mean), with(std))
            }
            Distribution::LogNormal { median, factor } => {
                format!("log-normal, {} times or over {}", with(median), number_text(factor))
            }
            Distribution::Choice { count } => {
                let ends = [self.values.first(), self.values.last()].map(|value| value.cloned());
                let [first, last] = ends.map(Option::unwrap_or_default);
                match count <= 4 {
                    true => format!("one of {}", self.values.join(", ")),
                    false => format!("one of {count}, {first} to {last}"),
                }
            }
        }
    }
}

/// Number of standard deviations from its mean that contains nearly all of a normal distribution.
const MOST: f64 = 3.0;
