//! What a calibration leaves as JSON: `summary.json`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::{
    ResultsError, Table,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of a calibration; raised when a key changes or goes.
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
    /// `soft` or `stiff`.
    pub model: String,
    /// What was looked for.
    pub estimates: Vec<EstimateFound>,
    /// What was held, by name, SI.
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
    /// Residuals larger than so many of their standard errors are outliers.
    pub outlier_beyond: f64,
    /// How many numbers were read.
    pub readings: usize,
    /// How many of them lie in the band of readings.
    pub within_band: usize,
    /// How many took no part in the fit and are held against it.
    pub held_out: usize,
    /// How many of those lie in the band.
    pub held_out_within_band: usize,
    /// Farthest that predictions between nodes are off, in errors of the readings.
    pub interpolation_error: f64,
    /// How many strings were solved.
    pub strings: usize,
    /// What is to be known of the answer, in sentences.
    pub notes: Vec<String>,
    /// What is to be wary of, in sentences.
    pub warnings: Vec<String>,
}

/// A number that was looked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EstimateFound {
    /// Name, with its unit: `friction_cased`, `block_weight_N`, ...
    pub parameter: String,
    /// In a sentence.
    pub words: String,
    /// Its value, SI.
    pub value: f64,
    /// Its standard error; none of a factor at zero.
    pub standard_error: Option<f64>,
    /// The interval by the profile likelihood; an end that is not found is none.
    pub interval: [Option<f64>; 2],
    /// It is a factor that would be negative, and is zero.
    pub at_bound: bool,
}

/// How far readings of a kind err.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ErrorFound {
    /// Which readings.
    pub readings: String,
    /// Whether they are torques and no weights.
    pub is_torque: bool,
    /// Their standard error, N or N·m.
    pub standard_error: f64,
    /// It was given, not estimated.
    pub given: bool,
    /// How many there are.
    pub count: usize,
    /// The sum of their squared residuals over the error.
    pub chi2: f64,
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
