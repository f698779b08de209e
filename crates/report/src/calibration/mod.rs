//! Contents of the page of a calibration, and its pictures.

mod figures;
mod page;

pub(crate) use figures::READINGS;
pub use figures::{CALIBRATION_PICTURES, calibration_plots, reading_words};
pub use page::calibration_html;

use crate::PageHead;

/// A calibration as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The fitted parameters.
    pub estimates: Vec<CalibratedRow>,
    /// Correlations of the estimates, a row for each.
    pub correlation: Vec<Vec<f64>>,
    /// Errors of the readings: kind, size, whether it is a torque, whether it was given, and number
    /// of readings.
    pub errors: Vec<(String, f64, bool, bool, usize)>,
    /// The result with the outliers, where they were left out, or without them: the loss that
    /// detected them, their names, whether they were left out, and a value with its standard error
    /// for each estimate.
    pub comparison: Option<CalibrationComparison>,
    /// Every reading.
    pub points: Vec<CalibrationPoint>,
    /// Predictions with their bands.
    pub bands: Vec<CalibrationBand>,
    /// Confidence of intervals and bands.
    pub confidence: [f64; 2],
    /// Residuals beyond this are outliers.
    pub outlier_beyond: f64,
    /// Some of the readings compared with the dynamic run; empty where that was not requested.
    pub dynamics: Vec<CalibrationCheck>,
    /// Number of readings within their band, and the width of the band, in SI, metric and field
    /// units; empty in results of earlier versions.
    pub band: [String; 3],
    /// Notes on the result, in sentences, in the same units.
    pub notes: [Vec<String>; 3],
    /// Warnings, in sentences, in the same units.
    pub warnings: [Vec<String>; 3],
}

/// The other result, with the outliers or without them.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationComparison {
    /// Name of the loss that found the outliers.
    pub loss: String,
    /// Their names.
    pub outliers: Vec<String>,
    /// Whether the main result leaves them out.
    pub left_out: bool,
    /// Words, value and standard error of each estimate.
    pub values: Vec<(String, f64, Option<f64>)>,
}

/// A fitted parameter.
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
    /// Value, excess of the sum of squares at it, and the same of a parabola.
    pub profile: Vec<[f64; 3]>,
}

/// A reading.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationPoint {
    /// The case whose string was in the hole.
    pub case: String,
    /// Place of the reading in its file.
    pub place: String,
    /// `pick_up`, ...
    pub reading: String,
    /// Whether it is a torque.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Whether it was used in the fit; otherwise it is only compared with it.
    pub used: bool,
    /// Measured value.
    pub measured: f64,
    /// By the model.
    pub predicted: f64,
    /// Measured less predicted.
    pub residual: f64,
    /// The band of readings.
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
    /// The case whose string is in the hole.
    pub case: String,
    /// `pick_up`, ...
    pub reading: String,
    /// Whether it is a torque.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Predicted value.
    pub predicted: f64,
    /// The band of the mean.
    pub mean: [f64; 2],
    /// The band of readings.
    pub reading_band: [f64; 2],
}

/// A reading compared with the dynamic run.
#[derive(Debug, Clone, PartialEq)]
pub struct CalibrationCheck {
    /// Place of the reading in its file.
    pub place: String,
    /// `pick_up`, ...
    pub reading: String,
    /// Whether it is a torque.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Measured value.
    pub measured: f64,
    /// Predicted by the model of the fit.
    pub predicted: f64,
    /// Mean and standard deviation by the dynamics; none without an answer.
    pub dynamic: Option<[f64; 2]>,
    /// Reason why there is none, or a note on it, in SI, metric and field units.
    pub said: [String; 3],
}
