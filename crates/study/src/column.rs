//! Columns of a case's results, of which figures and numbers of tables are made.

use serde_json::{Value as Json, json};
use wholestring_config::prelude::*;

/// Results of a case that have columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// `summary.json`: a number and its statistics for each case.
    Summary,
    /// `nodes.parquet`: along the string.
    Nodes,
    /// `wear.parquet`: along the hole.
    Wear,
    /// `time.parquet`: scalars against time.
    Time,
    /// `frames.parquet`: the whole string against time.
    Frames,
    /// `contact.parquet`: contact over depth and time.
    Contact,
    /// The path of the well down to the bit.
    Path,
}

/// The sources by their names.
pub(crate) const SOURCES: Choice<Source> = Choice {
    noun: "a part of the results",
    words: &[
        ("summary", Source::Summary),
        ("nodes", Source::Nodes),
        ("wear", Source::Wear),
        ("time", Source::Time),
        ("frames", Source::Frames),
        ("contact", Source::Contact),
        ("path", Source::Path),
    ],
};

impl Source {
    /// Its name in study files.
    pub fn name(self) -> &'static str {
        let found = SOURCES.words.iter().find(|(_, source)| *source == self);
        found.map_or("", |(name, _)| name)
    }
}

/// A column that results may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnName {
    /// Its source.
    pub source: Source,
    /// Its name, with the unit in it.
    pub name: &'static str,
    /// Its dimension; none if no unit converts it.
    pub dimension: Option<Dimension>,
}

/// A column, or its magnitude.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantity {
    /// The column.
    pub column: ColumnName,
    /// Whether the sign is dropped.
    pub magnitude: bool,
}

impl Quantity {
    /// The column written as `tension_N` or `|contact_force_N|`.
    pub(crate) fn named(
        at: &Spanned<String>,
        source: Source,
        columns: &[ColumnName],
        reader: &mut Reader,
    ) -> Option<Self> {
        let bars = at.value.strip_prefix('|').and_then(|rest| rest.strip_suffix('|'));
        let name = bars.unwrap_or(&at.value).trim();
        let of_source = columns.iter().filter(|column| column.source == source);
        if let Some(column) = of_source.clone().find(|column| column.name == name) {
            return Some(Self { column: *column, magnitude: bars.is_some() });
        }
        let table = source.name();
        let message = format!("there is no column `{}` in {table}", short(name));
        let mut diagnostic = Diagnostic::error(message).at(at.place, "unknown column");
        if let Some(near) = nearest(name, of_source.clone().map(|column| column.name)) {
            diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
        } else if let Some(home) = columns.iter().find(|column| column.name == name) {
            let home = home.source.name();
            diagnostic = diagnostic.help(format!("`{name}` is a column of {home}"));
        }
        let names: Vec<&str> = of_source.map(|column| column.name).collect();
        reader.report(diagnostic.help(format!("columns of {table}: {}", names.join(", "))));
        None
    }
}

/// Statistic of many values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Statistic {
    /// Their mean.
    Mean,
    /// Their standard deviation.
    Std,
    /// Mean and standard deviation added.
    MeanPlusStd,
    /// The smallest.
    Min,
    /// The largest.
    Max,
    /// This percentile.
    Percentile(f64),
}

impl Statistic {
    /// Its notation in study files.
    pub fn name(self) -> String {
        match self {
            Self::Mean => "mean".into(),
            Self::Std => "std".into(),
            Self::MeanPlusStd => "mean+std".into(),
            Self::Min => "min".into(),
            Self::Max => "max".into(),
            Self::Percentile(percent) => format!("p{percent:02}"),
        }
    }

    /// Whether summaries have it.
    pub(crate) fn is_summarised(self) -> bool {
        match self {
            Self::Percentile(percent) => percent == 5.0 || percent == 95.0,
            _ => true,
        }
    }
}

pub(crate) struct StatisticRule;

impl Rule for StatisticRule {
    type Value = Statistic;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Statistic> {
        const EXPECTED: &str =
            "\"mean\", \"std\", \"mean+std\", \"min\", \"max\" or a percentile such as \"p95\"";
        let Value::Text { text, .. } = &node.value else {
            reader.expected(node, EXPECTED);
            return None;
        };
        let percent = || {
            let percent: f64 = text.strip_prefix('p')?.parse().ok()?;
            (0.0..=100.0).contains(&percent).then_some(Statistic::Percentile(percent))
        };
        let found = match text.as_str() {
            "mean" => Some(Statistic::Mean),
            "std" => Some(Statistic::Std),
            "mean+std" => Some(Statistic::MeanPlusStd),
            "min" => Some(Statistic::Min),
            "max" => Some(Statistic::Max),
            _ => percent(),
        };
        if found.is_none() {
            let message = format!("`{}` is no statistic", short(text));
            reader
                .report(Diagnostic::error(message).at(node.place, format!("expected {EXPECTED}")));
        }
        found
    }

    fn schema(&self) -> Json {
        json!({ "type": "string", "pattern": "^(mean|std|mean\\+std|min|max|p[0-9.]+)$" })
    }

    fn json(&self, value: &Statistic) -> Json {
        json!(value.name())
    }
}

/// Refuses a percentile that summaries lack.
pub(crate) fn check_summarised(at: &Spanned<Statistic>, reader: &mut Reader) -> Option<()> {
    if at.value.is_summarised() {
        return Some(());
    }
    let message = format!("summaries have no `{}`", at.value.name());
    Diagnostic::error(message)
        .at(at.place, "expected \"p05\" or \"p95\"")
        .help("from = \"time\" or \"frames\" makes any percentile of the samples")
        .refuse(reader)
}

/// A given value, whose dimension depends on the compared quantity: text with a unit, or a bare
/// number.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Amount {
    Bare(f64),
    WithUnit(String),
}

pub(crate) struct AmountRule;

impl Rule for AmountRule {
    type Value = Amount;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Amount> {
        match &node.value {
            Value::Number { value, .. } if value.is_finite() => Some(Amount::Bare(*value)),
            Value::Text { text, .. } => Some(Amount::WithUnit(text.clone())),
            _ => {
                reader.expected(node, "a number, or text with a unit");
                None
            }
        }
    }

    fn schema(&self) -> Json {
        json!({ "anyOf": [{ "type": "number" }, { "type": "string" }] })
    }
}

impl Amount {
    /// Its value in SI in this dimension; an error if it has another.
    pub(crate) fn si(
        at: &Spanned<Self>,
        dimension: Option<Dimension>,
        reader: &mut Reader,
    ) -> Option<f64> {
        let text = match &at.value {
            Self::Bare(value) => return Some(*value),
            Self::WithUnit(text) => text,
        };
        let Some(dimension) = dimension else {
            let message =
                format!("`{}` has a unit, but the compared quantity has none", short(text));
            return Diagnostic::error(message)
                .at(at.place, "expected a number without quotes")
                .refuse(reader);
        };
        match dimension.parse(text) {
            Ok(si) => Some(si),
            Err(error) => {
                let symbols: Vec<&str> = dimension.units().iter().map(|unit| unit.symbol).collect();
                let name = dimension.name();
                let mut diagnostic = Diagnostic::error(error.to_string())
                    .at(at.place, format!("expected a quantity of {name}"));
                if let Some(help) = error.help() {
                    diagnostic = diagnostic.help(help);
                }
                reader.report(diagnostic.help(format!("units of {name}: {}", symbols.join(", "))));
                None
            }
        }
    }

    /// A fraction written in percent.
    pub(crate) fn share(&self) -> Option<f64> {
        match self {
            Self::WithUnit(text) => {
                let number = text.trim().strip_suffix('%')?.trim().parse::<f64>().ok()?;
                Some(number / 100.0).filter(|share| share.is_finite())
            }
            Self::Bare(_) => None,
        }
    }
}

/// A tolerance of zero is an error.
pub(crate) fn check_positive(value: f64, at: &Spanned<Amount>, reader: &mut Reader) -> Option<f64> {
    if value > 0.0 && value.is_finite() {
        return Some(value);
    }
    Diagnostic::error("the tolerance allows nothing")
        .at(at.place, "expected more than zero")
        .refuse(reader)
}
