//! The JSON file of a calibration: `summary.json`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::outcome::ModelKind;
use wholestring_judge::ReadingCheck;

use crate::{
    CALIBRATION_DYNAMIC, ResultsError, Table, Texts,
    json::{read_versioned, write_json},
    row::rows,
};

/// Version of the layout of the files of a calibration; raised when a key changes or is removed.
pub const CALIBRATION_VERSION: u32 = 1;

/// `summary.json` of a calibration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CalibrationSummary {
    /// [`CALIBRATION_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Names of the cases.
    pub cases: Vec<String>,
    /// Settings of the first with all defaults filled in.
    pub settings: Value,
    /// The file of the readings.
    pub data: String,
    /// The model: `soft` or `stiff`.
    pub model: ModelKind,
    /// The fitted parameters.
    pub estimates: Vec<EstimateFound>,
    /// The fixed parameters, by name, SI.
    pub held: Vec<(String, f64)>,
    /// Correlations of the estimates, a row for each.
    pub correlation: Vec<Vec<f64>>,
    /// Condition number of the correlations.
    pub condition: f64,
    /// Errors of the readings.
    pub errors: Vec<ErrorFound>,
    /// Sum of the squared residuals over their errors.
    pub chi2: f64,
    /// Readings less parameters.
    pub degrees_of_freedom: usize,
    /// Logarithm of the likelihood.
    pub log_likelihood: f64,
    /// Confidence of the intervals.
    pub confidence: f64,
    /// Confidence of the bands.
    pub band_confidence: f64,
    /// Residuals larger than this many of their standard errors are outliers.
    pub outlier_beyond: f64,
    /// Number of readings.
    pub readings: usize,
    /// Number of readings within the band of readings.
    pub within_band: usize,
    /// Number of readings that took no part in the fit and are compared with it.
    pub held_out: usize,
    /// Number of those within the band.
    pub held_out_within_band: usize,
    /// Largest error of predictions interpolated between nodes, in errors of the readings.
    pub interpolation_error: f64,
    /// Number of strings solved.
    pub strings: usize,
    /// Number of readings within their band, and the width of the band, in a sentence.
    #[serde(default)]
    pub status: String,
    /// The same fit with the outliers where they were left out, and without them where they were
    /// not; none where there are no outliers.
    #[serde(default)]
    pub comparison: Option<OutlierComparison>,
    /// Every check of the readings and of the fit.
    #[serde(default)]
    pub checks: Vec<ReadingCheck>,
    /// Notes on the result, in sentences; includes those of the checks.
    pub notes: Vec<String>,
    /// Warnings, in sentences: those of the checks.
    pub warnings: Vec<String>,
    /// Dynamic runs with the fitted numbers, compared with some of the readings; empty where none
    /// were requested.
    #[serde(default)]
    pub dynamics: Vec<DynamicCheck>,
    /// Quantities of its texts, from which they are rendered in other units.
    #[serde(default, skip_serializing_if = "Texts::is_empty")]
    pub texts: Texts,
}

/// The fit of all readings, to compare with that without outliers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OutlierComparison {
    /// Name of the loss of the robust fit, of which and of the fit of all readings these are outliers.
    pub loss: String,
    /// The outliers: `pick-up of line 5`.
    pub outliers: Vec<String>,
    /// Whether the estimates of the summary leave the outliers out; those here are the others.
    pub left_out: bool,
    /// The estimates of the other fit.
    pub estimates: Vec<EstimateFound>,
}

/// A reading, and the value of the dynamic run for it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DynamicCheck {
    /// The case that was in the hole.
    pub case: String,
    /// Place of the reading in its file.
    pub place: String,
    /// As in `calibration.parquet`.
    pub reading: String,
    /// Whether it is a torque, N·m, rather than a weight, N.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Measured value; weights include the block.
    pub measured: f64,
    /// Predicted by the model of the fit.
    pub predicted: f64,
    /// Value of the dynamic run; none without an answer.
    pub dynamic: Option<InMotion>,
    /// Reason why there is none.
    pub message: Option<String>,
}

/// Mean and scatter of a load of a string in motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct InMotion {
    /// Mean over the window; weights include the block.
    pub mean: f64,
    /// Standard deviation over the window.
    pub std: f64,
    /// Mean of the bit's measured depth over the window, m.
    pub mean_bit_depth_m: f64,
    /// Whether the string had settled; none where the case gives the start of the window.
    pub steady: Option<bool>,
}

/// A fitted parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EstimateFound {
    /// Name, with its unit: `friction_cased`, `block_weight_N`, ...
    pub parameter: String,
    /// The estimate as a sentence.
    pub words: String,
    /// Its value, SI.
    pub value: f64,
    /// Its standard error; none for a factor at zero.
    pub standard_error: Option<f64>,
    /// The interval by the profile likelihood; an end that is not found is none.
    pub interval: [Option<f64>; 2],
    /// Whether the unconstrained value is negative, so that it is set to zero.
    pub at_bound: bool,
}

/// Error of readings of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ErrorFound {
    /// Kind of the readings.
    pub readings: String,
    /// Whether they are torques rather than weights.
    pub is_torque: bool,
    /// Their standard error, N or N·m.
    pub standard_error: f64,
    /// Whether it was given rather than estimated.
    pub given: bool,
    /// Number of readings.
    pub count: usize,
    /// The sum of their squared residuals over the error.
    pub chi2: f64,
}

rows! {
    /// A value at which a parameter was fixed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CalibrationProfile {
        parameter: String => Words,
            "As in the summary: `friction_cased`, `block_weight_N`, ...";
        value: f64 => Ratio, "Fixed value, in the unit at the end of the parameter's name";
        excess: f64 => Ratio, "Excess of the sum of squared residuals over its minimum";
        parabola: f64 => Ratio, "The same excess by the standard error alone";
    }

    /// Columns of `calibration_profiles.parquet`: a row for each value at which a parameter was
    /// fixed.
    pub const CALIBRATION_PROFILES, read;
}

/// The tables of a calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationTables {
    /// `calibration.parquet`.
    pub points: Table,
    /// `calibration_bands.parquet`.
    pub bands: Table,
    /// `calibration_profiles.parquet`.
    pub profiles: Table,
}

impl CalibrationSummary {
    /// The first case, and how many more there are.
    pub fn title(&self) -> String {
        match &self.cases[..] {
            [] => String::new(),
            [one] => one.clone(),
            [first, others @ ..] => format!("{first} and {} more", others.len()),
        }
    }

    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a summary, and refuses one of another [`CALIBRATION_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, CALIBRATION_VERSION..=CALIBRATION_VERSION)
    }
}

/// Returns a row for each reading that was compared with the dynamics.
pub fn calibration_dynamic_table(checks: &[DynamicCheck]) -> Table {
    let mut table = Table::with_columns(CALIBRATION_DYNAMIC);
    for check in checks {
        let dynamic = |value: fn(&InMotion) -> f64| check.dynamic.as_ref().map_or(f64::NAN, value);
        let values = [
            check.measured,
            check.predicted,
            dynamic(|motion| motion.mean),
            dynamic(|motion| motion.std),
        ];
        let none = [f64::NAN; 4];
        let (weights, torques) = if check.is_torque { (none, values) } else { (values, none) };
        let steady = check.dynamic.and_then(|dynamic| dynamic.steady);
        let steady = steady.map_or("", |is| if is { "yes" } else { "no" });
        table.append(
            &[
                ("case", &[&check.case]),
                ("place", &[&check.place]),
                ("reading", &[&check.reading]),
                ("steady", &[steady]),
                ("message", &[check.message.as_deref().unwrap_or_default()]),
            ],
            &[
                ("bit_depth_m", &[check.bit_depth_m]),
                ("mean_bit_depth_m", &[dynamic(|motion| motion.mean_bit_depth_m)]),
                ("measured_N", &[weights[0]]),
                ("predicted_N", &[weights[1]]),
                ("dynamic_N", &[weights[2]]),
                ("dynamic_std_N", &[weights[3]]),
                ("measured_N_m", &[torques[0]]),
                ("predicted_N_m", &[torques[1]]),
                ("dynamic_N_m", &[torques[2]]),
                ("dynamic_std_N_m", &[torques[3]]),
            ],
        );
    }
    table
}
