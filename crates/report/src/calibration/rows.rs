//! Readings, predictions and profiles of a calibration, from its tables.

use wholestring_results::Table;

/// A reading.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CalibrationPoint {
    /// The case whose string was in the hole.
    pub(super) case: String,
    /// Place of the reading in its file.
    pub(super) place: String,
    /// `pick_up`, ...
    pub(super) reading: String,
    /// Whether it is a torque.
    pub(super) is_torque: bool,
    /// Measured depth of the bit, m.
    pub(super) bit_depth_m: f64,
    /// Whether it was used in the fit; otherwise it is only compared with it.
    pub(super) used: bool,
    /// Measured value.
    pub(super) measured: f64,
    /// By the model.
    pub(super) predicted: f64,
    /// Measured less predicted.
    pub(super) residual: f64,
    /// The band of readings.
    pub(super) reading_band: [f64; 2],
    /// Residual over its standard error.
    pub(super) standardised: f64,
    /// Beyond the bound.
    pub(super) outlier: bool,
    /// In the band.
    pub(super) within_band: bool,
}

/// A prediction with its band.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CalibrationBand {
    /// The case whose string is in the hole.
    pub(super) case: String,
    /// `pick_up`, ...
    pub(super) reading: String,
    /// Whether it is a torque.
    pub(super) is_torque: bool,
    /// Measured depth of the bit, m.
    pub(super) bit_depth_m: f64,
    /// Predicted value.
    pub(super) predicted: f64,
    /// The band of the mean.
    pub(super) mean: [f64; 2],
    /// The band of readings.
    pub(super) reading_band: [f64; 2],
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

/// The profile of a parameter in `calibration_profiles.parquet`: value, excess of the sum of
/// squares at it, and the same of a parabola.
pub(super) fn profile(table: &Table, parameter: &str) -> Vec<[f64; 3]> {
    let columns = ["value", "excess", "parabola"].map(|name| numbers(table, name));
    let rows = words(table, "parameter").into_iter().enumerate();
    let rows = rows.filter(|(_, name)| name == parameter);
    rows.map(|(row, _)| columns.each_ref().map(|column| column[row])).collect()
}

/// Readings of `calibration.parquet`.
pub(super) fn points(table: &Table) -> Vec<CalibrationPoint> {
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

/// Predictions of `calibration_bands.parquet`.
pub(super) fn bands(table: &Table) -> Vec<CalibrationBand> {
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
