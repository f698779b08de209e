//! `[plan.uncertain]`: uncertain numbers of the case.

use wholestring_config::prelude::*;
use wholestring_plan::{
    Statics,
    uncertainty::{Distribution, DistributionError},
};

use crate::{
    edit::{
        overrides::Quote,
        vary::{Quantity as Amount, Variation},
    },
    uncertain::{Uncertain, UncertainInput},
    values::STATICS,
};

/// Default number of samples.
const SAMPLES: u64 = 200;

/// Maximum number of samples.
const MAX_SAMPLES: u64 = 100_000;

/// Maximum number of inputs.
const MAX_INPUTS: usize = 50;

table! {
    /// Uncertain numbers of the case: plan and reach then show uncertainty bands, and the
    /// contribution of each of these numbers to the bands. The bands are those of the expected
    /// friction; low and high friction are unchanged.
    UncertainTable in "[plan.uncertain]" {
        /// The numbers, each independent of the others.
        input: Vec<Spanned<InputTable>> = optional(List::tables::<InputTable>(
            "inputs ([[plan.uncertain.input]])", MAX_INPUTS,
        ));
        /// Number of samples, a Latin hypercube.
        samples: u64 = default(Count { from: 10, to: MAX_SAMPLES }, SAMPLES);
        /// Seed of the draw: the same seed gives the same samples.
        seed: u64 = default(Whole, 1);
        /// The model of the samples of a plan, "soft" or "stiff" (some ten times the work). A reach
        /// uses the soft string.
        model: Statics = default(
            Choice { noun: "a model of samples", words: STATICS },
            Statics::Soft,
        );
    }
}

table! {
    /// A number of the case and its distribution: uniform (`from`, `to`), triangular (`mode` too),
    /// normal (`mean`, `std`, and `from` or `to` or both where it is truncated), log-normal
    /// (`median`, `factor`), or one of `values`. Its numbers are written in the form of the key,
    /// all in one unit.
    InputTable in "[[plan.uncertain.input]]" {
        /// Key of the case in the form of `--set`: `mud.density`, `well.hole.1.friction` (lists
        /// counted from zero), or `friction`, `bit_depth`, `rpm`, `wob`.
        key: String = required(Text);
        /// Lower limit.
        from: GivenAmount = optional(AmountRule);
        /// Upper limit.
        to: GivenAmount = optional(AmountRule);
        /// Most likely value.
        mode: GivenAmount = optional(AmountRule);
        /// Mean of the distribution.
        mean: GivenAmount = optional(AmountRule);
        /// Standard deviation.
        std: GivenAmount = optional(AmountRule);
        /// Median: half of the values are below it.
        median: GivenAmount = optional(AmountRule);
        /// Geometric standard deviation: about two thirds of the values are between the median over
        /// this and the median times this.
        factor: f64 = optional(Number { unit: "", range: Range::from_to(1.0, 1e3) });
        /// Values that are equally likely, such as [1, 2, 3], or a range "FROM..TO/STEP", such as
        /// "1..200/1" for seeds.
        values: Variation = optional(ValuesRule);
    }
}

/// A number and its unit as written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GivenAmount {
    number: f64,
    unit: String,
    apart: bool,
}

/// A number, or one with its unit.
struct AmountRule;

impl Rule for AmountRule {
    type Value = GivenAmount;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<GivenAmount> {
        let expected = "a decimal number, or one with its unit such as \"1.2 sg\"";
        let (number, unit, apart) = match &node.value {
            Value::Number { value, .. } => (*value, String::new(), false),
            Value::Text { text, .. } => {
                // Draws are decimal numbers: of `5-1/2 in` only the beginning would change.
                let amount = Amount::read(text).filter(|amount| {
                    let starts = |letter: char| letter.is_alphabetic() || "°%µ\"'".contains(letter);
                    amount.unit.starts_with(starts)
                });
                match amount {
                    Some(amount) => (amount.number, amount.unit.to_owned(), amount.apart),
                    None => {
                        let message = format!("`{}` is not a quantity", reader.key);
                        return Diagnostic::error(message)
                            .at(node.place, format!("expected {expected}"))
                            .refuse(reader);
                    }
                }
            }
            _ => {
                reader.expected(node, expected);
                return None;
            }
        };
        if !number.is_finite() {
            let message = format!("`{}` is not a finite number", reader.key);
            return Diagnostic::error(message)
                .at(node.place, format!("expected {expected}"))
                .refuse(reader);
        }
        Some(GivenAmount { number, unit, apart })
    }

    fn schema(&self) -> serde_json::Value {
        serde_json::json!({ "type": ["number", "string"] })
    }
}

/// A list of values, or a range of them, in the form of sweeps.
struct ValuesRule;

impl Rule for ValuesRule {
    type Value = Variation;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Variation> {
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            Value::Text { .. } => std::slice::from_ref(node),
            _ => {
                reader.expected(node, "a list such as [1, 2, 3], or a range such as \"1..200/1\"");
                return None;
            }
        };
        let mut variation = Variation { key: "values".to_owned(), values: Vec::new() };
        for item in items {
            let written = reader.text_at(item.place).to_owned();
            let says = match &item.value {
                Value::Text { text, .. } => text,
                Value::Number { .. } => &written,
                _ => {
                    let message = format!("`values` cannot be {}", item.value.noun());
                    return Diagnostic::error(message)
                        .at(item.place, "expected numbers, or numbers with their unit")
                        .refuse(reader);
                }
            };
            // The quotation does not matter, because values are set in the case's tree unchanged.
            let quote =
                Quote { name: "".into(), text: "".into(), key: 0..0, value: 0..0, verbatim: false };
            if !variation.take([says, says], quote, item.place, reader) {
                return None;
            }
        }
        Some(variation)
    }

    fn schema(&self) -> serde_json::Value {
        serde_json::json!({
            "anyOf": [
                { "type": "array", "items": { "type": ["number", "string"] } },
                { "type": "string" },
            ]
        })
    }
}

/// Builds the uncertain inputs; `None` for a plan without any.
pub(crate) fn build(table: &UncertainTable, reader: &mut Reader) -> Option<Option<Uncertain>> {
    let Some(Spanned { value: tables, .. }) = table.input.optional()? else {
        let places = [table.samples.place(), table.seed.place(), table.model.place()];
        return match places.into_iter().flatten().next() {
            None => Some(None),
            Some(place) => Diagnostic::error("[plan.uncertain] lacks [[plan.uncertain.input]]")
                .at(place, "nothing is uncertain")
                .help("such as input = [{ key = \"friction\", from = 0.2, to = 0.4 }]")
                .refuse(reader),
        };
    };
    let mut inputs: Vec<UncertainInput> = Vec::new();
    let mut valid = true;
    for at in tables {
        let Some(input) = input(&at.value, at.place, reader) else {
            valid = false;
            continue;
        };
        if let Some(first) = inputs.iter().find(|other| other.key == input.key) {
            Diagnostic::error(format!("`{}` is uncertain twice", short(&input.key)))
                .at(input.key_place, "again here")
                .at(first.key_place, "first here")
                .report(reader);
            valid = false;
        }
        inputs.push(input);
    }
    let samples = usize::try_from(*table.samples.get()?).ok()?;
    let uncertain =
        Uncertain { inputs, samples, seed: *table.seed.get()?, model: *table.model.get()? };
    valid.then_some(Some(uncertain))
}

/// Forms of a distribution.
const FORMS: &str = "`from` and `to`; these and `mode`; `mean` and `std`, with `from` or `to` or both \
    where it is cut off; `median` and `factor`; or `values`";

fn input(table: &InputTable, place: Span, reader: &mut Reader) -> Option<UncertainInput> {
    let key = table.key.at()?;
    if key.value.starts_with("plan.uncertain") {
        return Diagnostic::error("the inputs of [plan.uncertain] cannot be uncertain themselves")
            .at(key.place, "expected another key of the case")
            .refuse(reader);
    }
    let fields = [
        ("from", &table.from),
        ("to", &table.to),
        ("mode", &table.mode),
        ("mean", &table.mean),
        ("std", &table.std),
        ("median", &table.median),
    ];
    let mut amounts = Vec::new();
    for (name, field) in fields {
        if let Some(at) = field.optional()? {
            amounts.push((name, at));
        }
    }
    let (factor, values) = (table.factor.optional()?, table.values.optional()?);
    let number = |name: &str| {
        let found = amounts.iter().find(|(amount, _)| *amount == name);
        found.map(|(_, at)| at.value.number)
    };
    let names: Vec<&str> = amounts.iter().map(|(name, _)| *name).collect();
    let number_or_nan = |name: &str| number(name).unwrap_or(f64::NAN);
    let distribution = match (&names[..], factor, values) {
        (["from", "to"], None, None) => {
            Distribution::Uniform { from: number_or_nan("from"), to: number_or_nan("to") }
        }
        (["from", "to", "mode"], None, None) => Distribution::Triangular {
            from: number_or_nan("from"),
            mode: number_or_nan("mode"),
            to: number_or_nan("to"),
        },
        (["mean", "std"], None, None) => {
            Distribution::Normal { mean: number_or_nan("mean"), std: number_or_nan("std") }
        }
        (["from", "to", "mean", "std"] | ["from" | "to", "mean", "std"], None, None) => {
            Distribution::TruncatedNormal {
                mean: number_or_nan("mean"),
                std: number_or_nan("std"),
                from: number("from").unwrap_or(f64::NEG_INFINITY),
                to: number("to").unwrap_or(f64::INFINITY),
            }
        }
        (["median"], Some(factor), None) => {
            Distribution::LogNormal { median: number_or_nan("median"), factor: factor.value }
        }
        ([], None, Some(values)) => Distribution::Choice { count: values.value.values.len() },
        _ => {
            let mut names: Vec<&str> = names.clone();
            names.extend(factor.map(|_| "factor"));
            names.extend(values.map(|_| "values"));
            let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            let message = match names.is_empty() {
                true => format!("`{}` is uncertain, but has no distribution", short(&key.value)),
                false => format!("{} alone do not define a distribution", names.join(", ")),
            };
            return Diagnostic::error(message)
                .at(place, "expected a range or a distribution")
                .help(format!("give {FORMS}"))
                .refuse(reader);
        }
    };
    let first = amounts.first();
    if let Some((_, first)) = first
        && let Some((name, other)) =
            amounts.iter().find(|(_, at)| at.value.unit != first.value.unit)
    {
        return Diagnostic::error("the numbers of a distribution have one unit")
            .at(other.place, format!("`{name}` in another unit"))
            .at(first.place, "than this")
            .refuse(reader);
    }
    if let Err(error) = distribution.checked() {
        let at =
            |name: &str| amounts.iter().find(|(amount, _)| *amount == name).map(|(_, at)| at.place);
        let at = match error {
            DistributionError::NotFinite => None,
            DistributionError::Empty { .. } => at("to"),
            DistributionError::CutAway { .. } => at("from").or_else(|| at("to")),
            DistributionError::Mode { .. } => at("mode"),
            DistributionError::Deviation(_) => at("std"),
            DistributionError::Median(_) => at("median"),
            DistributionError::Factor(_) => factor.map(|at| at.place),
            DistributionError::NoChoice => values.map(|at| at.place),
        };
        let message = format!("`{}` has no such distribution", short(&key.value));
        return Diagnostic::error(message)
            .at(at.unwrap_or(place), error.to_string())
            .refuse(reader);
    }
    // The place of its first number, because underlining a whole table does not help.
    let spot = first.map(|(_, at)| at.place).or_else(|| values.map(|at| at.place));
    Some(UncertainInput {
        key: key.value.trim().to_owned(),
        distribution,
        unit: first.map_or_else(String::new, |(_, at)| at.value.unit.clone()),
        apart: first.is_some_and(|(_, at)| at.value.apart),
        values: values
            .map_or_else(Vec::new, |at| at.value.bare_values().map(str::to_owned).collect()),
        key_place: key.place,
        place: spot.unwrap_or(place),
    })
}
