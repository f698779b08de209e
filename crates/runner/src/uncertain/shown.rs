//! What uncertain numbers come to, as pages show it.

use wholestring_judge::CheckKind;
use wholestring_plan::reach::Limit;
use wholestring_report::{Uncertain, UncertainNumber, UncertainShares};
use wholestring_results::{UncertainBand, UncertainStop, UncertainSummary};

use super::{Names, notes};
use crate::page::facts::readable;

/// Everything that a page shows of it, with the names of its tables.
pub(crate) fn shown(of: &UncertainSummary, names: &Names) -> Uncertain {
    Uncertain {
        notes: notes(of),
        inputs: of.inputs.iter().map(|of| [of.key.clone(), of.distribution.clone()]).collect(),
        bands: of.bands.iter().map(number).collect(),
        stops: of.stops.iter().map(stop).collect(),
        files: [names.bands, names.indices, names.samples, names.stops.unwrap_or_default()]
            .map(str::to_owned),
    }
}

/// A limit in words: some of a plan and of a reach have one name.
fn limit(name: &str, of_reach: bool) -> &str {
    let found = match of_reach {
        true => Limit::ALL.iter().find(|of| of.name() == name).map(|of| of.title()),
        false => CheckKind::named(name).map(CheckKind::label),
    };
    found.unwrap_or(name)
}

fn number(of: &UncertainBand) -> UncertainNumber {
    let of_reach = matches!(of.quantity.as_str(), "depth" | "margin");
    let limit = if of.limit.is_empty() { "" } else { limit(&of.limit, of_reach) };
    let title = match of.quantity.as_str() {
        "reserve" => format!("reserve: {limit}"),
        "depth" if limit.is_empty() => "depth of the first stop".to_owned(),
        "depth" => format!("depth: {limit}"),
        "sinusoidal_weight" => "weight to buckle: sinusoid".to_owned(),
        "helical_weight" => "weight to buckle: helix".to_owned(),
        other => other.replace('_', " "),
    };
    let dimension = match of.unit.as_str() {
        "N" => "force",
        "N·m" => "torque",
        "m" => "length",
        _ => "ratio",
    };
    UncertainNumber {
        quantity: of.quantity.clone(),
        title,
        limit: limit.to_owned(),
        operation: if of_reach { readable(&of.operation) } else { of.operation.clone() },
        friction: of.friction,
        bit_depth_m: of.bit_depth_m,
        dimension: dimension.to_owned(),
        expected: of.expected.unwrap_or(f64::NAN),
        quantiles: of.quantiles,
        answers: of.answers,
        without_answer: of.without_answer,
        not_met: of.not_met,
        owed: of.owed.as_ref().map(|owed| UncertainShares {
            first: owed.first.iter().map(|of| of.unwrap_or(f64::NAN)).collect(),
            total: owed.total.clone(),
            predicts: owed.predicts,
        }),
    }
}

fn stop(of: &UncertainStop) -> (String, usize) {
    let at = of.friction.map_or_else(String::new, |friction| format!(", friction {friction}"));
    let what = match of.limit.is_empty() {
        true => format!("nothing{at}"),
        false => format!("{}, {}{at}", limit(&of.limit, true), readable(&of.operation)),
    };
    (what, of.samples)
}
