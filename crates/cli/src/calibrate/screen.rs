//! Output of a calibration on the screen.

use wholestring_results::{CalibrationSummary, EstimateFound, OutlierComparison};
use wholestring_units::{Dimension, UnitSet};

use crate::screen_table::Table;

/// A factor with four decimals, a weight or torque in the chosen unit.
fn shown(estimate: &EstimateFound, value: f64, units: UnitSet) -> String {
    let dimension = match estimate.parameter.as_str() {
        "block_weight_N" => Dimension::Force,
        "bit_torque_N_m" => Dimension::Torque,
        _ => return format!("{value:.4}"),
    };
    let unit = dimension.unit_in(units);
    format!("{:.2} {}", unit.from_si(value), unit.symbol)
}

/// The estimates as a table, notes and warnings.
pub(crate) fn text(summary: &CalibrationSummary, units: UnitSet) -> String {
    let title =
        format!("{}: {} readings, {} string", summary.title(), summary.readings, summary.model);
    let interval = format!("interval of {:.0} %", 100.0 * summary.confidence);
    let mut table = Table::new(&title, 1, &["number", "value", "standard error", &interval]);
    for estimate in &summary.estimates {
        let show = |value: f64| shown(estimate, value, units);
        let end = |end: Option<f64>| end.map_or("not found".to_owned(), show);
        table.row(vec![
            estimate.words.clone(),
            show(estimate.value),
            estimate.standard_error.map_or("at zero".to_owned(), show),
            format!("{} to {}", end(estimate.interval[0]), end(estimate.interval[1])),
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

/// The estimates of all readings next to those without the outliers.
fn comparison(summary: &CalibrationSummary, other: &OutlierComparison, units: UnitSet) -> String {
    let mut table =
        Table::new("With and without outliers", 1, &["number", "all readings", "without outliers"]);
    for estimate in &summary.estimates {
        let same = other.estimates.iter().find(|one| one.parameter == estimate.parameter);
        let value = |estimate: Option<&EstimateFound>| {
            estimate.map_or("–".to_owned(), |estimate| {
                let error = estimate
                    .standard_error
                    .map_or(String::new(), |error| format!(" ± {}", shown(estimate, error, units)));
                shown(estimate, estimate.value, units) + &error
            })
        };
        let (own, same) = (value(Some(estimate)), value(same));
        let [all, without] = if other.left_out { [same, own] } else { [own, same] };
        table.row(vec![estimate.words.clone(), all, without]);
    }
    table.text()
}

/// Readings next to the results of the dynamic model.
fn dynamics(summary: &CalibrationSummary, units: UnitSet) -> String {
    let depth = Dimension::Length.unit_in(units);
    let title = "Checked by the dynamics: mean and standard deviation";
    let fitted = format!("{} string", summary.model);
    let at = format!("bit at, {}", depth.symbol);
    let headings = ["reading", "unit", &at, "measured", &fitted, "in motion", "±"];
    let mut table = Table::new(title, 2, &headings);
    for dynamic in &summary.dynamics {
        let unit =
            if dynamic.is_torque { Dimension::Torque } else { Dimension::Force }.unit_in(units);
        let digits = if unit.from_si(dynamic.measured).abs() < 1000.0 { 2 } else { 0 };
        let number = |value: f64| format!("{:.digits$}", unit.from_si(value));
        let [mean, std] =
            dynamic.dynamic.map_or(["no answer".to_owned(), "–".to_owned()], |found| {
                [number(found.mean), number(found.std)]
            });
        let reading = dynamic.reading.replace('_', "-");
        let at = format!("{:.0}", depth.from_si(dynamic.bit_depth_m));
        let symbol = unit.symbol.to_owned();
        table.row(vec![
            reading,
            symbol,
            at,
            number(dynamic.measured),
            number(dynamic.predicted),
            mean,
            std,
        ]);
    }
    table.text()
}
