//! The JSON file of a calibration: `summary.json`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::outcome::ModelKind;
use wholestring_judge::ReadingCheck;

use crate::{
    CalibrationBand, CalibrationProfile, CalibrationReading, DynamicCheck, ResultsError, Texts,
    json::{read_versioned, write_json},
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

/// A fitted parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct EstimateFound {
    /// Name, with its unit: `friction_cased`, `block_weight_N`, ...
    pub parameter: String,
    /// The parameter in words.
    pub words: String,
    /// Its value, SI.
    pub value: f64,
    /// Its standard error; none for a factor at zero.
    pub standard_error: Option<f64>,
    /// The interval by the profile likelihood; an end that is not found is none.
    #[cfg_attr(feature = "openapi", schema(min_items = 2, max_items = 2))]
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

/// The rows of the tables of a calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationRows {
    /// `calibration.parquet`.
    pub readings: Vec<CalibrationReading>,
    /// `calibration_bands.parquet`.
    pub bands: Vec<CalibrationBand>,
    /// `calibration_profiles.parquet`.
    pub profiles: Vec<CalibrationProfile>,
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
