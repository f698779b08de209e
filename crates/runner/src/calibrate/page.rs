//! `report.html` and the pictures of a calibration, made from the files in its folder.

use std::path::Path;

use wholestring_report::{
    CALIBRATION_PICTURES, CalibratedRow, Calibration, CalibrationBand, CalibrationCheck,
    CalibrationComparison, CalibrationPoint, Cell, Fact, PageHead, Plot, calibration_html,
    calibration_plots, in_sets,
};
use wholestring_results::{CalibrationSummary, DynamicCheck, ResultsError, Table};
use wholestring_units::UnitSet;

use super::{
    tables::{BANDS, POINTS, PROFILES},
    toml::FRAGMENT,
};
use crate::{
    page::{self, table},
    results_kind::Results,
};

impl Results for Calibration {
    const NOUN: &'static str = "a calibration";
    const TABLE: &'static str = PROFILES;
    const PICTURES: &'static [&'static str] = &CALIBRATION_PICTURES;
    const FILES: &'static [&'static str] = &[FRAGMENT];

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = CalibrationSummary::read(&folder.join("summary.json"))?;
        let title = format!("{}: measured friction", summary.title());
        let head = PageHead::new(title, units, Some(&summary.settings), facts(&summary));
        let profiles = table(folder, PROFILES)?;
        let rows = summary.estimates.iter().map(|estimate| {
            let (dimension, _) =
                page::dimensions::of_setting(&estimate.parameter).unwrap_or_default();
            CalibratedRow {
                words: estimate.words.clone(),
                dimension: dimension.to_owned(),
                value: estimate.value,
                standard_error: estimate.standard_error,
                interval: estimate.interval,
                profile: profile(&profiles, &estimate.parameter),
            }
        });
        let errors = summary.errors.iter().map(|error| {
            (
                error.readings.clone(),
                error.standard_error,
                error.is_torque,
                error.given,
                error.count,
            )
        });
        Ok(Self {
            estimates: rows.collect(),
            errors: errors.collect(),
            comparison: summary.comparison.as_ref().map(|other| CalibrationComparison {
                loss: other.loss.clone(),
                outliers: other.outliers.clone(),
                left_out: other.left_out,
                values: other
                    .estimates
                    .iter()
                    .map(|estimate| {
                        (estimate.words.clone(), estimate.value, estimate.standard_error)
                    })
                    .collect(),
            }),
            points: points(&table(folder, POINTS)?),
            bands: bands(&table(folder, BANDS)?),
            correlation: summary.correlation.clone(),
            confidence: [summary.confidence, summary.band_confidence],
            outlier_beyond: summary.outlier_beyond,
            dynamics: summary.dynamics.iter().map(|check| checked(&summary, check)).collect(),
            band: in_sets(|units| summary.texts.in_units(&summary.status, units)),
            notes: in_sets(|units| texts(&summary, &summary.notes, units)),
            warnings: in_sets(|units| texts(&summary, &summary.warnings, units)),
            head,
        })
    }

    fn html(&self) -> Option<String> {
        Some(calibration_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        calibration_plots(self, &self.head.units)
    }
}

fn checked(summary: &CalibrationSummary, check: &DynamicCheck) -> CalibrationCheck {
    let dynamic = check.dynamic.as_ref();
    CalibrationCheck {
        place: check.place.clone(),
        reading: check.reading.clone(),
        is_torque: check.is_torque,
        bit_depth_m: check.bit_depth_m,
        measured: check.measured,
        predicted: check.predicted,
        dynamic: dynamic.map(|dynamic| [dynamic.mean, dynamic.std]),
        said: in_sets(|units| match (dynamic.and_then(|dynamic| dynamic.steady), &check.message) {
            (_, Some(message)) => summary.texts.in_units(message, units),
            (Some(false), _) => "not settled".to_owned(),
            _ => String::new(),
        }),
    }
}

/// Texts of a calibration in these units.
fn texts(summary: &CalibrationSummary, texts: &[String], units: UnitSet) -> Vec<String> {
    texts.iter().map(|text| summary.texts.in_units(text, units)).collect()
}

/// Key facts of the calibration.
fn facts(summary: &CalibrationSummary) -> Vec<Fact> {
    let fact = |label: &str, text: String| Fact { label: label.into(), value: Cell::Text(text) };
    let file = Path::new(&summary.data).file_name();
    let file = file.map_or(summary.data.clone(), |name| name.to_string_lossy().into_owned());
    vec![
        fact("Readings", format!("{} of {file}", summary.readings)),
        fact("Model", format!("{} string", summary.model)),
        fact("χ²", format!("{:.1}", summary.chi2)),
        fact("Degrees of freedom", summary.degrees_of_freedom.to_string()),
    ]
}

fn numbers(table: &Table, name: &str) -> Vec<f64> {
    let column = table.numbers(name).unwrap_or_default();
    column.iter().map(|value| value.unwrap_or(f64::NAN)).collect()
}

fn words(table: &Table, name: &str) -> Vec<String> {
    table.words(name).unwrap_or_default().to_vec()
}

/// Merges a weight's column and a torque's: each row has a number in one of them.
fn either(table: &Table, name: &str) -> Vec<f64> {
    let (weights, torques) =
        (numbers(table, &format!("{name}_N")), numbers(table, &format!("{name}_N_m")));
    let pick = |(weight, torque): (f64, f64)| if weight.is_finite() { weight } else { torque };
    weights.into_iter().zip(torques).map(pick).collect()
}

fn profile(table: &Table, parameter: &str) -> Vec<[f64; 3]> {
    let columns = ["value", "excess", "parabola"].map(|name| numbers(table, name));
    let rows = words(table, "parameter").into_iter().enumerate();
    let rows = rows.filter(|(_, name)| name == parameter);
    rows.map(|(row, _)| columns.each_ref().map(|column| column[row])).collect()
}

fn points(table: &Table) -> Vec<CalibrationPoint> {
    let [case, place, reading] = ["case", "place", "reading"].map(|name| words(table, name));
    let [used, depth, standardised, outlier, within] =
        ["used", "bit_depth_m", "standardised", "outlier", "within_band"]
            .map(|name| numbers(table, name));
    let kinds = ["measured", "predicted", "residual", "reading_low", "reading_high"];
    let [measured, predicted, residual, low, high] = kinds.map(|name| either(table, name));
    let point = |row: usize| CalibrationPoint {
        case: case[row].clone(),
        place: place[row].clone(),
        is_torque: reading[row].starts_with("torque"),
        reading: reading[row].clone(),
        bit_depth_m: depth[row],
        used: used[row] > 0.0,
        measured: measured[row],
        predicted: predicted[row],
        residual: residual[row],
        reading_band: [low[row], high[row]],
        standardised: standardised[row],
        outlier: outlier[row] > 0.0,
        within_band: within[row] > 0.0,
    };
    (0..table.rows()).map(point).collect()
}

fn bands(table: &Table) -> Vec<CalibrationBand> {
    let [case, reading] = ["case", "reading"].map(|name| words(table, name));
    let depth = numbers(table, "bit_depth_m");
    let ends = ["predicted", "mean_low", "mean_high", "reading_low", "reading_high"];
    let [predicted, mean_low, mean_high, low, high] = ends.map(|name| either(table, name));
    let band = |row: usize| CalibrationBand {
        case: case[row].clone(),
        is_torque: reading[row].starts_with("torque"),
        reading: reading[row].clone(),
        bit_depth_m: depth[row],
        predicted: predicted[row],
        mean: [mean_low[row], mean_high[row]],
        reading_band: [low[row], high[row]],
    };
    (0..table.rows()).map(band).collect()
}
