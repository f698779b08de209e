//! What uncertain numbers come to, in sentences.

use wholestring_report::operation_name;
use wholestring_results::{UncertainBand, UncertainSummary};
use wholestring_units::{Dimension, UnitSet};

/// Reasons that are told; more are counted.
const REASONS: usize = 3;

/// Inputs to which less of the variance is owed are not named.
const NAMED: f64 = 0.05;

/// A fit that predicts less of the variance than this says little.
const PREDICTS: f64 = 0.9;

/// What the bands are of, and what is missing from them.
pub fn notes(of: &UncertainSummary) -> Vec<String> {
    let numbers = match of.inputs.len() {
        1 => "one uncertain number".to_owned(),
        count => format!("{count} uncertain numbers"),
    };
    let mut notes = vec![format!(
        "Bands: 5 to 95 % of {} samples of {numbers}, {} string, seed {}.",
        of.solved, of.model, of.seed
    )];
    if of.solved < of.samples {
        notes.push(format!("Interrupted: {} of {} samples were solved.", of.solved, of.samples));
    }
    if of.lacking > 0 {
        let told = of.reasons.iter().take(REASONS);
        let told: Vec<String> = told.map(|(why, count)| format!("{why} ({count})")).collect();
        let more = of.reasons.len().saturating_sub(REASONS);
        let more = if more > 0 { format!("; and {more} other reasons") } else { String::new() };
        notes.push(format!(
            "{} of {} samples have points without an answer, which are in no band: {}{more}.",
            of.lacking,
            of.solved,
            told.join("; ")
        ));
    }
    notes
}

/// How hook load and torque scatter with the bit at its deepest, and how far a well goes; each with the
/// inputs that it is owed to.
pub fn scatter(of: &UncertainSummary, units: UnitSet) -> Vec<String> {
    let deepest_m = of.bands.iter().filter_map(|of| of.bit_depth_m).fold(0.0, f64::max);
    let is_told = |band: &&UncertainBand| match band.quantity.as_str() {
        "hook_load" | "surface_torque" => {
            band.bit_depth_m == Some(deepest_m) && band.owed.is_some()
        }
        "depth" => band.limit.is_empty(),
        _ => false,
    };
    of.bands.iter().filter(is_told).map(|band| sentence(of, band, units)).collect()
}

fn sentence(of: &UncertainSummary, band: &UncertainBand, units: UnitSet) -> String {
    let (dimension, name, decimals) = match band.quantity.as_str() {
        "hook_load" => (Dimension::Force, "hook load", 1),
        "surface_torque" => (Dimension::Torque, "torque", 1),
        _ => (Dimension::Length, "reach", 0),
    };
    let unit = dimension.unit_in(units);
    let value = |si: f64| format!("{:.decimals$}", unit.from_si(si));
    let [low, _, middle, _, high] = band.quantiles.map(value);
    let whose = match (band.operation.as_str(), band.friction) {
        ("", Some(friction)) => format!("friction {friction}: "),
        ("", None) => String::new(),
        (name, _) => format!("{}: ", operation_name(name)),
    };
    let mut text = format!("{whose}{name} {low} to {high}, middle {middle} {}", unit.symbol);
    if band.not_met > 0 {
        text += &format!(", in {} of {} samples nothing stops it", band.not_met, band.answers);
    }
    if band.without_answer > 0 {
        text += &format!(", {} without an answer", band.without_answer);
    }
    if let Some(owed) = &band.owed {
        let mut shares: Vec<(&str, f64)> =
            of.inputs.iter().map(|of| of.key.as_str()).zip(owed.total.iter().copied()).collect();
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        let named = shares.iter().filter(|(_, share)| *share >= NAMED);
        let named: Vec<String> =
            named.map(|(key, share)| format!("{:.0} % due to {key}", 100.0 * share)).collect();
        text += &format!("; {}", named.join(", "));
        if owed.predicts < PREDICTS && owed.first.iter().all(Option::is_some) {
            text += &format!(
                " (little sure: the fit predicts {:.0} %)",
                100.0 * owed.predicts.max(0.0)
            );
        }
    }
    text + "."
}
