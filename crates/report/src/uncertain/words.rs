//! Words for the numbers of uncertain inputs.

use wholestring::operation::OperationKind;
use wholestring_judge::{CheckKind, DepthLimit};
use wholestring_results::{UncertainBand, UncertainStop, UncertainSummary};

/// Largest number of reasons that are listed; the others are counted.
const REASONS: usize = 3;

/// Notes on the bands and on missing samples.
pub fn uncertain_notes(summary: &UncertainSummary) -> Vec<String> {
    let numbers = match summary.inputs.len() {
        1 => "one uncertain number".to_owned(),
        count => format!("{count} uncertain numbers"),
    };
    let mut notes = vec![format!(
        "Bands: 5 to 95 % of {} samples of {numbers}, {} string, seed {}.",
        summary.solved, summary.model, summary.seed
    )];
    if summary.solved < summary.samples {
        notes.push(format!(
            "Interrupted: {} of {} samples were solved.",
            summary.solved, summary.samples
        ));
    }
    if summary.lacking > 0 {
        let reasons = summary.reasons.iter().take(REASONS);
        let reasons: Vec<String> = reasons.map(|(why, count)| format!("{why} ({count})")).collect();
        let more = summary.reasons.len().saturating_sub(REASONS);
        let more = if more > 0 { format!("; and {more} other reasons") } else { String::new() };
        notes.push(format!(
            "{} of {} samples have points without an answer, which are in no band: {}{more}.",
            summary.lacking,
            summary.solved,
            reasons.join("; ")
        ));
    }
    notes
}

/// A limit in words; limits of a plan and of a reach may have the same name.
fn limit(name: &str, of_reach: bool) -> &str {
    let found = match of_reach {
        true => DepthLimit::named(name).map(DepthLimit::title),
        false => CheckKind::named(name).map(CheckKind::label),
    };
    found.unwrap_or(name)
}

/// The limit of a number in words; empty for other numbers.
fn band_limit(band: &UncertainBand) -> &str {
    let of_reach = matches!(band.quantity.as_str(), "depth" | "margin");
    if band.limit.is_empty() { "" } else { limit(&band.limit, of_reach) }
}

/// Name of a number in words, with its limit.
pub(super) fn title(band: &UncertainBand) -> String {
    let limit = band_limit(band);
    match band.quantity.as_str() {
        "reserve" => format!("reserve: {limit}"),
        "depth" if limit.is_empty() => "depth of the first stop".to_owned(),
        "depth" => format!("depth: {limit}"),
        "sinusoidal_weight" => "weight to buckle: sinusoid".to_owned(),
        "helical_weight" => "weight to buckle: helix".to_owned(),
        other => other.replace('_', " "),
    }
}

/// Dimension of a number.
pub(super) fn dimension(band: &UncertainBand) -> &'static str {
    match band.unit.as_str() {
        "N" => "force",
        "N·m" => "torque",
        "m" => "length",
        _ => "ratio",
    }
}

/// A limit that stops a well first, with its operation and friction; `nothing` where none does.
pub(super) fn stop(stop: &UncertainStop) -> String {
    let at = stop.friction.map_or_else(String::new, |friction| format!(", friction {friction}"));
    match stop.limit {
        None => format!("nothing{at}"),
        Some(limit) => {
            let operation = stop.operation.map_or("", OperationKind::words);
            format!("{}, {operation}{at}", limit.title())
        }
    }
}
