//! What a calibration shows on the screen.

use wholestring_results::{CalibrationSummary, EstimateFound, OutlierComparison};
use wholestring_units::{Dimension, UnitSet};

use crate::screen_table::Table;

/// A factor in four decimals, a weight or torque in the reader's unit.
fn shown(of: &EstimateFound, value: f64, units: UnitSet) -> String {
    let dimension = match of.parameter.as_str() {
        "block_weight_N" => Dimension::Force,
        "bit_torque_N_m" => Dimension::Torque,
        _ => return format!("{value:.4}"),
    };
    let unit = dimension.unit_in(units);
    format!("{:.2} {}", unit.from_si(value), unit.symbol)
}

/// What was found as a table, what is to be known of it, and warnings.
pub(super) fn text(summary: &CalibrationSummary, units: UnitSet) -> String {
    let title =
        format!("{}: {} readings, {} string", summary.title(), summary.readings, summary.model);
    let interval = format!("interval of {:.0} %", 100.0 * summary.confidence);
    let mut table = Table::new(&title, 1, &["number", "value", "standard error", &interval]);
    for of in &summary.estimates {
        let show = |value: f64| shown(of, value, units);
        let end = |end: Option<f64>| end.map_or("not found".to_owned(), show);
        table.row(vec![
            of.words.clone(),
            show(of.value),
            of.standard_error.map_or("at zero".to_owned(), show),
            format!("{} to {}", end(of.interval[0]), end(of.interval[1])),
        ]);
    }
    let mut text = table.text();
    if let Some(other) = &summary.comparison {
        text += &comparison(summary, other, units);
    }
    text.extend(summary.warnings.iter().map(|warning| format!("warning: {warning}\n")));
    text += &format!(
        "χ² {:.1}, {} degrees of freedom; {}\n",
        summary.chi2, summary.degrees_of_freedom, summary.status
    );
    if summary.held_out > 0 {
        text += &format!(
            "held out: {} of {} readings within the band\n",
            summary.held_out_within_band, summary.held_out
        );
    }
    if !summary.dynamics.is_empty() {
        text += &dynamics(summary, units);
    }
    text.extend(summary.notes.iter().map(|note| format!("note: {note}\n")));
    text
}

/// What is found of all readings beside what is found without the outliers.
fn comparison(summary: &CalibrationSummary, other: &OutlierComparison, units: UnitSet) -> String {
    let title = format!("With and without the outliers that {}'s loss finds", other.loss);
    let mut table = Table::new(&title, 1, &["number", "all readings", "without outliers"]);
    for of in &summary.estimates {
        let same = other.estimates.iter().find(|one| one.parameter == of.parameter);
        let value = |of: Option<&EstimateFound>| {
            of.map_or("–".to_owned(), |of| {
                let error = of
                    .standard_error
                    .map_or(String::new(), |error| format!(" ± {}", shown(of, error, units)));
                shown(of, of.value, units) + &error
            })
        };
        let (own, same) = (value(Some(of)), value(same));
        let [all, without] = if other.left_out { [same, own] } else { [own, same] };
        table.row(vec![of.words.clone(), all, without]);
    }
    table.text()
}

/// Readings beside the string in motion.
fn dynamics(summary: &CalibrationSummary, units: UnitSet) -> String {
    let depth = Dimension::Length.unit_in(units);
    let title = "Checked by the dynamics: mean and standard deviation";
    let fitted = format!("{} string", summary.model);
    let at = format!("bit at, {}", depth.symbol);
    let headings = ["reading", "unit", &at, "measured", &fitted, "in motion", "±"];
    let mut table = Table::new(title, 2, &headings);
    for of in &summary.dynamics {
        let unit = if of.is_torque { Dimension::Torque } else { Dimension::Force }.unit_in(units);
        let digits = if unit.from_si(of.measured).abs() < 1000.0 { 2 } else { 0 };
        let number = |value: f64| format!("{:.digits$}", unit.from_si(value));
        let [mean, std] = of.dynamic.map_or(["no answer".to_owned(), "–".to_owned()], |found| {
            [number(found.mean), number(found.std)]
        });
        let reading = of.reading.replace('_', "-");
        let at = format!("{:.0}", depth.from_si(of.bit_depth_m));
        let symbol = unit.symbol.to_owned();
        table.row(vec![reading, symbol, at, number(of.measured), number(of.predicted), mean, std]);
    }
    table.text()
}
