//! Results for uncertain inputs, in the form of the page.

use wholestring::operation::OperationKind;
use wholestring_judge::CheckKind;
use wholestring_plan::reach::Limit;
use wholestring_report::{Uncertain, UncertainNumber, UncertainShares};
use wholestring_results::{UncertainBand, UncertainStop, UncertainSummary};

use super::{Names, notes};

/// Page data of the results, with the names of the tables.
pub(crate) fn shown(summary: &UncertainSummary, names: &Names) -> Uncertain {
    Uncertain {
        notes: notes(summary),
        inputs: summary
            .inputs
            .iter()
            .map(|input| [input.key.clone(), input.distribution.clone()])
            .collect(),
        bands: summary.bands.iter().map(number).collect(),
        stops: summary.stops.iter().map(stop).collect(),
        files: [names.bands, names.indices, names.samples, names.stops.unwrap_or_default()]
            .map(str::to_owned),
    }
}

/// A limit in words; limits of a plan and of a reach may have the same name.
fn limit(name: &str, of_reach: bool) -> &str {
    let found = match of_reach {
        true => Limit::ALL.iter().find(|limit| limit.name() == name).map(|limit| limit.title()),
        false => CheckKind::named(name).map(CheckKind::label),
    };
    found.unwrap_or(name)
}

fn number(band: &UncertainBand) -> UncertainNumber {
    let of_reach = matches!(band.quantity.as_str(), "depth" | "margin");
    let limit = if band.limit.is_empty() { "" } else { limit(&band.limit, of_reach) };
    let title = match band.quantity.as_str() {
        "reserve" => format!("reserve: {limit}"),
        "depth" if limit.is_empty() => "depth of the first stop".to_owned(),
        "depth" => format!("depth: {limit}"),
        "sinusoidal_weight" => "weight to buckle: sinusoid".to_owned(),
        "helical_weight" => "weight to buckle: helix".to_owned(),
        other => other.replace('_', " "),
    };
    let dimension = match band.unit.as_str() {
        "N" => "force",
        "N·m" => "torque",
        "m" => "length",
        _ => "ratio",
    };
    UncertainNumber {
        quantity: band.quantity.clone(),
        title,
        limit: limit.to_owned(),
        operation: band.operation,
        friction: band.friction,
        bit_depth_m: band.bit_depth_m,
        dimension: dimension.to_owned(),
        expected: band.expected.unwrap_or(f64::NAN),
        quantiles: band.quantiles,
        answers: band.answers,
        without_answer: band.without_answer,
        not_met: band.not_met,
        owed: band.owed.as_ref().map(|owed| UncertainShares {
            first: owed.first.iter().map(|first| first.unwrap_or(f64::NAN)).collect(),
            total: owed.total.clone(),
            predicts: owed.predicts,
        }),
    }
}

fn stop(stop: &UncertainStop) -> (String, usize) {
    let at = stop.friction.map_or_else(String::new, |friction| format!(", friction {friction}"));
    let what = match stop.limit.is_empty() {
        true => format!("nothing{at}"),
        false => {
            let operation = stop.operation.map_or("", OperationKind::words);
            format!("{}, {operation}{at}", limit(&stop.limit, true))
        }
    };
    (what, stop.samples)
}
