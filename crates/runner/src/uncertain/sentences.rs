//! Results for uncertain inputs, in sentences.

use wholestring_results::{UncertainBand, UncertainSummary};
use wholestring_units::{Dimension, UnitSet};

/// Inputs with a smaller sensitivity index are not named.
const NAMED: f64 = 0.05;

/// A fit that predicts a smaller fraction of the variance than this is reported as poor.
const PREDICTS: f64 = 0.9;

/// Scatter of hook load and torque at the deepest bit, and of the reach of a well, each with the
/// inputs of the largest sensitivity.
pub fn scatter(summary: &UncertainSummary, units: UnitSet) -> Vec<String> {
    let deepest_m = summary.bands.iter().filter_map(|band| band.bit_depth_m).fold(0.0, f64::max);
    let is_told = |band: &&UncertainBand| match band.quantity.as_str() {
        "hook_load" | "surface_torque" => {
            band.bit_depth_m == Some(deepest_m) && band.owed.is_some()
        }
        "depth" => band.limit.is_empty(),
        _ => false,
    };
    summary.bands.iter().filter(is_told).map(|band| sentence(summary, band, units)).collect()
}

fn sentence(summary: &UncertainSummary, band: &UncertainBand, units: UnitSet) -> String {
    let (dimension, name, decimals) = match band.quantity.as_str() {
        "hook_load" => (Dimension::Force, "hook load", 1),
        "surface_torque" => (Dimension::Torque, "torque", 1),
        _ => (Dimension::Length, "reach", 0),
    };
    let unit = dimension.unit_in(units);
    let value = |si: f64| format!("{:.decimals$}", unit.from_si(si));
    let [low, _, middle, _, high] = band.quantiles.map(value);
    let whose = match (band.operation, band.friction) {
        (None, Some(friction)) => format!("friction {friction}: "),
        (None, None) => String::new(),
        (Some(operation), _) => format!("{operation}: "),
    };
    let mut text = format!("{whose}{name} {low} to {high}, median {middle} {}", unit.symbol);
    if band.not_met > 0 {
        text += &format!(", in {} of {} samples no limit is reached", band.not_met, band.answers);
    }
    if band.without_answer > 0 {
        text += &format!(", {} without an answer", band.without_answer);
    }
    if let Some(owed) = &band.owed {
        let mut shares: Vec<(&str, f64)> = summary
            .inputs
            .iter()
            .map(|input| input.key.as_str())
            .zip(owed.total.iter().copied())
            .collect();
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        let named = shares.iter().filter(|(_, share)| *share >= NAMED);
        let named: Vec<String> =
            named.map(|(key, share)| format!("{:.0} % due to {key}", 100.0 * share)).collect();
        text += &format!("; {}", named.join(", "));
        if owed.predicts < PREDICTS && owed.first.iter().all(Option::is_some) {
            text += &format!(
                " (uncertain: the fit predicts {:.0} % of the variance)",
                100.0 * owed.predicts.max(0.0)
            );
        }
    }
    text + "."
}
