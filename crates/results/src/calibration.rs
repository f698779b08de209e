//! What a calibration leaves as JSON: `summary.json`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring_judge::ReadingCheck;

use crate::{
    CALIBRATION_DYNAMIC, ResultsError, Table,
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
    /// How many readings lie in their band, and how wide it is, in a sentence.
    #[serde(default)]
    pub status: String,
    /// The same fit with the outliers where they were left out, and without them where they were not; none where
    /// there are none.
    #[serde(default)]
    pub comparison: Option<OutlierComparison>,
    /// Every check of the readings and of the fit.
    #[serde(default)]
    pub checks: Vec<ReadingCheck>,
    /// What is to be known of the answer, in sentences; those of the checks too.
    pub notes: Vec<String>,
    /// Warnings, in sentences: those of the checks.
    pub warnings: Vec<String>,
    /// The string in motion, with the numbers that were found, beside some of the readings; empty where it was not asked
    /// for.
    #[serde(default)]
    pub dynamics: Vec<DynamicCheck>,
}

/// The fit of all readings beside that without outliers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OutlierComparison {
    /// Name of the loss by which the outliers were found.
    pub loss: String,
    /// The outliers: `pick-up of line 5`.
    pub outliers: Vec<String>,
    /// Whether the estimates of the summary leave the outliers out; those here are the others.
    pub left_out: bool,
    /// What is found the other way.
    pub estimates: Vec<EstimateFound>,
}

/// A reading, and what the string in motion makes of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DynamicCheck {
    /// The case that was in the hole.
    pub case: String,
    /// Where the reading stands in its file.
    pub place: String,
    /// As in `calibration.parquet`.
    pub reading: String,
    /// Whether it is a torque, N·m, and no weight, N.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// As it was read; weights with the block's.
    pub measured: f64,
    /// By the model that the numbers were found with.
    pub predicted: f64,
    /// By the dynamics; none without an answer.
    pub dynamic: Option<InMotion>,
    /// Why there is none.
    pub message: Option<String>,
}

/// Mean and scatter of a load of a string in motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct InMotion {
    /// Mean over the window; weights with the block's.
    pub mean: f64,
    /// Standard deviation over the window.
    pub std: f64,
    /// Measured depth of the bit, on average over the window, m.
    pub mean_bit_depth_m: f64,
    /// Whether the string had settled; none where the case says when the window begins.
    pub steady: Option<bool>,
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
    /// It would be negative, and is zero.
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

/// A row for each reading that the dynamics were held against.
pub fn calibration_dynamic_table(checks: &[DynamicCheck]) -> Table {
    let mut table = Table::with_columns(CALIBRATION_DYNAMIC);
    for of in checks {
        let dynamic = |value: fn(&InMotion) -> f64| of.dynamic.as_ref().map_or(f64::NAN, value);
        let values = [of.measured, of.predicted, dynamic(|of| of.mean), dynamic(|of| of.std)];
        let none = [f64::NAN; 4];
        let (weights, torques) = if of.is_torque { (none, values) } else { (values, none) };
        let steady = of.dynamic.and_then(|of| of.steady);
        let steady = steady.map_or("", |is| if is { "yes" } else { "no" });
        table.append(
            &[
                ("case", &[&of.case]),
                ("place", &[&of.place]),
                ("reading", &[&of.reading]),
                ("steady", &[steady]),
                ("message", &[of.message.as_deref().unwrap_or_default()]),
            ],
            &[
                ("bit_depth_m", &[of.bit_depth_m]),
                ("mean_bit_depth_m", &[dynamic(|of| of.mean_bit_depth_m)]),
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
