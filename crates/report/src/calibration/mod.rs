//! What a page reports of a calibration, and its pictures.

mod figures;
mod page;

pub(crate) use figures::READINGS;
pub use figures::{CALIBRATION_PICTURES, calibration_plots};
pub use page::calibration_html;

use crate::PageHead;

/// A calibration as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// Under the name of the case.
    pub head: PageHead,
    /// What was looked for.
    pub estimates: Vec<CalibratedRow>,
    /// Correlations of the estimates, a row for each.
    pub correlation: Vec<Vec<f64>>,
    /// Errors of the readings: which, how large, whether it is a torque, given, how many.
    pub errors: Vec<(String, f64, bool, bool, usize)>,
    /// What is found with the outliers, where they were left out, or without them: the loss that found them, their
    /// names, whether they were left out, and a value with its standard error for each estimate.
    pub comparison: Option<CalibrationComparison>,
    /// Every reading.
    pub points: Vec<CalibrationPoint>,
    /// Predictions with their bands.
    pub bands: Vec<CalibrationBand>,
    /// Confidence of intervals and bands.
    pub confidence: [f64; 2],
    /// Residuals beyond this are outliers.
    pub outlier_beyond: f64,
    /// Some of the readings beside the string in motion; empty where that was not asked for.
    pub dynamics: Vec<CalibrationCheck>,
    /// What is to be known of the answer, in sentences.
    pub notes: Vec<String>,
    /// Warnings, in sentences.
    pub warnings: Vec<String>,
}

/// The other answer, with the outliers or without them.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationComparison {
    /// Name of the loss that found the outliers.
    pub loss: String,
    /// Their names.
    pub outliers: Vec<String>,
    /// Whether the main answer leaves them out.
    pub left_out: bool,
    /// By the words of each estimate, its value and standard error.
    pub values: Vec<(String, f64, Option<f64>)>,
}

/// A number that was looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibratedRow {
    /// In a sentence.
    pub words: String,
    /// Name of its dimension.
    pub dimension: String,
    /// Its value.
    pub value: f64,
    /// Its standard error.
    pub standard_error: Option<f64>,
    /// The interval by the profile likelihood.
    pub interval: [Option<f64>; 2],
    /// Value, how much greater the sum of squares is there, and what a parabola has.
    pub profile: Vec<[f64; 3]>,
}

/// A number that was read.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationPoint {
    /// The case that was in the hole.
    pub case: String,
    /// Where it stands in its file.
    pub place: String,
    /// `pick_up`, ...
    pub reading: String,
    /// Whether it is a torque.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Whether the numbers were found from it; it is only held against them otherwise.
    pub used: bool,
    /// As it was read.
    pub measured: f64,
    /// By the model.
    pub predicted: f64,
    /// Measured less predicted.
    pub residual: f64,
    /// The band in which a reading lies.
    pub reading_band: [f64; 2],
    /// Residual over its standard error.
    pub standardised: f64,
    /// Beyond the bound.
    pub outlier: bool,
    /// In the band.
    pub within_band: bool,
}

/// A prediction with its band.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationBand {
    /// The case that is in the hole.
    pub case: String,
    /// `pick_up`, ...
    pub reading: String,
    /// Whether it is a torque.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// What is predicted.
    pub predicted: f64,
    /// The band of the mean.
    pub mean: [f64; 2],
    /// The band of readings.
    pub reading_band: [f64; 2],
}

/// A reading beside the string in motion.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationCheck {
    /// Where it stands in its file.
    pub place: String,
    /// `pick_up`, ...
    pub reading: String,
    /// Whether it is a torque.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// As it was read.
    pub measured: f64,
    /// By the model that the numbers were found with.
    pub predicted: f64,
    /// Mean and standard deviation by the dynamics; none without an answer.
    pub dynamic: Option<[f64; 2]>,
    /// Why there is none, or what is to be known of it.
    pub said: String,
}
