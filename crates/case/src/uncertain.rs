//! Numbers of a case that are not known exactly, and the samples that are drawn of them.

use serde::{Serialize, Serializer};
use wholestring_config::{
    node::{Key, parse_value},
    prelude::*,
};
use wholestring_plan::{
    Statics,
    uncertainty::{Distribution, latin_hypercube},
};

use crate::overrides::put;

/// What is not known exactly, and how often it is drawn.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Uncertain {
    /// The numbers, each independent of the others.
    pub inputs: Vec<UncertainInput>,
    /// How many samples are drawn.
    pub samples: usize,
    /// Seed of the draw.
    pub seed: u64,
    /// The model of the samples.
    pub model: Statics,
}

/// A number of the case that is not known exactly.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UncertainInput {
    /// Dotted or short key of the case.
    pub key: String,
    /// How it is distributed, in `unit`; of a choice, the numbers of its values.
    #[serde(serialize_with = "as_text")]
    pub distribution: Distribution,
    /// Its unit as written; empty of a bare number.
    pub unit: String,
    /// Whether a blank stands before the unit.
    #[serde(skip)]
    pub(crate) apart: bool,
    /// Of a choice, its values as a case has them.
    pub values: Vec<String>,
    /// Where key and distribution stand.
    #[serde(skip)]
    pub(crate) key_place: Span,
    #[serde(skip)]
    pub(crate) place: Span,
}

/// Its ends may be infinite, of which JSON has no number.
fn as_text<S: Serializer>(of: &Distribution, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&format_args!("{of:?}"))
}

impl Uncertain {
    /// A row for each sample, with a value of each input.
    pub fn points(&self) -> Vec<Vec<f64>> {
        latin_hypercube(&self.distributions(), self.samples, self.seed)
    }

    /// How each input is distributed.
    pub fn distributions(&self) -> Vec<Distribution> {
        self.inputs.iter().map(|of| of.distribution).collect()
    }

    /// Puts a value of each input into the tree of a case, which is certain then.
    pub(crate) fn put(&self, point: &[f64], root: &mut Entries, reader: &mut Reader) {
        make_certain(root);
        for (input, value) in self.inputs.iter().zip(point) {
            put(root, &input.key, &input.node(*value), input.key_place, reader);
        }
    }
}

/// Takes out what a case says of its uncertain numbers.
pub(crate) fn make_certain(root: &mut Entries) {
    if let Some(Node { value: Value::Table(plan), .. }) = root.get_mut("plan") {
        plan.0.retain(|(Key { name, .. }, _)| name != "uncertain");
    }
}

impl UncertainInput {
    /// A value as a case has it: `0.3`, `1.2 sg`, one of a choice.
    pub fn written(&self, value: f64) -> String {
        if !self.values.is_empty() {
            return self.values.get(value as usize).cloned().unwrap_or_default();
        }
        let blank = if self.apart { " " } else { "" };
        format!("{value}{blank}{}", self.unit)
    }

    /// The same in six digits, for people.
    pub(crate) fn rounded(&self, value: f64) -> String {
        match self.values.is_empty() {
            true => self.written(format!("{value:.5e}").parse().unwrap_or(value)),
            false => self.written(value),
        }
    }

    /// A value as a table has it: of a choice among numbers the number itself.
    pub fn number(&self, value: f64) -> f64 {
        match self.values.is_empty() {
            true => value,
            false => self.written(value).parse().unwrap_or(f64::NAN),
        }
    }

    /// The same in the tree of a case.
    pub(crate) fn node(&self, value: f64) -> Node {
        let Self { place, .. } = *self;
        let text = self.written(value);
        let value = match parse_value(&text, place.source, place.start) {
            Ok(Node { value: found @ Value::Number { .. }, .. }) => found,
            _ => Value::Text { text, verbatim_from: None },
        };
        Node { place, value }
    }

    /// Between which values it lies, or nearly all of it, in its unit; none of a choice.
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

    /// How it is distributed, as people say it.
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
                let ends = [self.values.first(), self.values.last()].map(|of| of.cloned());
                let [first, last] = ends.map(Option::unwrap_or_default);
                match count <= 4 {
                    true => format!("one of {}", self.values.join(", ")),
                    false => format!("one of {count}, {first} to {last}"),
                }
            }
        }
    }
}

/// So many standard deviations from its mean lies nearly all of a normal distribution.
const MOST: f64 = 3.0;
