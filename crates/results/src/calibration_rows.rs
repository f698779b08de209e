//! Rows of the tables of a calibration.

use serde::{Deserialize, Serialize};

use crate::{
    loads::{torque, weight},
    row::rows,
};

rows! {
    /// A reading, and its prediction with the fitted numbers.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CalibrationReading {
        case: String => Words, "The case whose string was in the hole";
        place: String => Words, "Place of the reading in its file";
        reading: String => Words,
            "`pick_up`, `slack_off`, `rotating`, `torque` or `torque_on_bottom`";
        used: bool => Ratio,
            "1 where the reading took part in the fit, 0 where it is only compared with it";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        measured_N: Option<f64> => Force, "Measured weight, block included; `null` for torques",
            null_where "it is a torque";
        predicted_N: Option<f64> => Force,
            "Weight by the model with the fitted numbers, block included; `null` for torques",
            null_where "it is a torque";
        residual_N: Option<f64> => Force, "Measured less predicted; `null` for torques",
            null_where "it is a torque";
        predicted_error_N: Option<f64> => Force,
            "Standard error of the prediction by those of the fitted numbers; `null` for torques",
            null_where "it is a torque";
        reading_low_N: Option<f64> => Force,
            "Lower end of the band of readings; `null` for torques",
            null_where "it is a torque";
        reading_high_N: Option<f64> => Force, "Its upper end; `null` for torques",
            null_where "it is a torque";
        measured_N_m: Option<f64> => Torque, "Measured torque; `null` for weights",
            null_where "it is a weight";
        predicted_N_m: Option<f64> => Torque,
            "Torque by the model with the fitted numbers; `null` for weights",
            null_where "it is a weight";
        residual_N_m: Option<f64> => Torque, "Measured less predicted; `null` for weights",
            null_where "it is a weight";
        predicted_error_N_m: Option<f64> => Torque,
            "Standard error of the prediction by those of the fitted numbers; `null` for weights",
            null_where "it is a weight";
        reading_low_N_m: Option<f64> => Torque,
            "Lower end of the band of readings; `null` for weights",
            null_where "it is a weight";
        reading_high_N_m: Option<f64> => Torque, "Its upper end; `null` for weights",
            null_where "it is a weight";
        standardised: f64 => Ratio,
            "Measured less predicted, over its standard error after the fit";
        outlier: bool => Ratio, "1 where that is beyond the bound of outliers, 0 otherwise";
        within_band: bool => Ratio,
            "1 where the reading is within the band of readings, 0 otherwise";
    }

    /// Columns of `calibration.parquet`: a row for each reading.
    pub const CALIBRATION, read;
}

rows! {
    /// Prediction of a kind of reading at a depth, and its bands.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CalibrationBand {
        case: String => Words, "The case whose string is in the hole";
        reading: String => Words, "As in `calibration.parquet`";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        predicted_N: Option<f64> => Force,
            "Predicted weight, block included; `null` for torques",
            null_where "it is a torque";
        mean_low_N: Option<f64> => Force, "Lower end of the band of the mean; `null` for torques",
            null_where "it is a torque";
        mean_high_N: Option<f64> => Force, "Its upper end; `null` for torques",
            null_where "it is a torque";
        reading_low_N: Option<f64> => Force,
            "Lower end of the band of readings; `null` for torques",
            null_where "it is a torque";
        reading_high_N: Option<f64> => Force, "Its upper end; `null` for torques",
            null_where "it is a torque";
        predicted_N_m: Option<f64> => Torque, "Predicted torque; `null` for weights",
            null_where "it is a weight";
        mean_low_N_m: Option<f64> => Torque,
            "Lower end of the band of the mean; `null` for weights",
            null_where "it is a weight";
        mean_high_N_m: Option<f64> => Torque, "Its upper end; `null` for weights",
            null_where "it is a weight";
        reading_low_N_m: Option<f64> => Torque,
            "Lower end of the band of readings; `null` for weights",
            null_where "it is a weight";
        reading_high_N_m: Option<f64> => Torque, "Its upper end; `null` for weights",
            null_where "it is a weight";
    }

    /// Columns of `calibration_bands.parquet`: a row for each kind of reading at each depth.
    pub const CALIBRATION_BANDS, read;
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

rows! {
    /// A reading, and the value of the dynamic run for it.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct DynamicCheck {
        case: String => Words, "The case whose string was in the hole";
        place: String => Words, "Place of the reading in its file";
        reading: String => Words, "As in `calibration.parquet`";
        is_torque: bool, "Whether it is a torque, N·m, rather than a weight, N";
        bit_depth_m: f64 => Depth, "Measured depth of the bit at the reading";
        measured: f64, "Measured value; weights include the block";
        predicted: f64, "Predicted by the model of the fit";
        dynamic: Option<InMotion>, "Value of the dynamic run; none without an answer";
        mean_bit_depth_m = |check| check.dynamic.map(|motion| motion.mean_bit_depth_m) => Depth,
            "Mean of the same in the dynamic run; `null` without an answer",
            null_where "there is no answer";
        measured_N = |check| weight(check.is_torque, check.measured) => Force,
            "Measured weight, block included; `null` for torques",
            null_where "it is a torque";
        predicted_N = |check| weight(check.is_torque, check.predicted) => Force,
            "The same by the model of the fit; `null` for torques",
            null_where "it is a torque";
        dynamic_N = |check| weight(check.is_torque, check.mean()) => Force,
            "Mean by the dynamics, block included; `null` for torques and without an answer",
            null_where "it is a torque, or there is no answer";
        dynamic_std_N = |check| weight(check.is_torque, check.std()) => Force,
            "Standard deviation against time; `null` as the mean",
            null_where "it is a torque, or there is no answer";
        measured_N_m = |check| torque(check.is_torque, check.measured) => Torque,
            "Measured torque; `null` for weights",
            null_where "it is a weight";
        predicted_N_m = |check| torque(check.is_torque, check.predicted) => Torque,
            "The same by the model of the fit; `null` for weights",
            null_where "it is a weight";
        dynamic_N_m = |check| torque(check.is_torque, check.mean()) => Torque,
            "Mean by the dynamics; `null` for weights and without an answer",
            null_where "it is a weight, or there is no answer";
        dynamic_std_N_m = |check| torque(check.is_torque, check.std()) => Torque,
            "Standard deviation against time; `null` as the mean",
            null_where "it is a weight, or there is no answer";
        steady = |check| check.dynamic.map(|motion| motion.steady) => Words,
            "Whether the string had settled: `yes` or `no`; empty where the case gives the start \
             of the window, or there is no answer",
            null_where "the case gives the start of the window, or there is no answer";
        message: Option<String> => Words, "Reason why there is no answer; else empty",
            null_where "there is an answer";
    }

    /// Columns of `calibration_dynamic.parquet`: a row for each reading that was compared with a
    /// dynamic run with the fitted numbers.
    pub const CALIBRATION_DYNAMIC;
}

impl DynamicCheck {
    fn mean(&self) -> Option<f64> {
        self.dynamic.map(|motion| motion.mean)
    }

    fn std(&self) -> Option<f64> {
        self.dynamic.map(|motion| motion.std)
    }
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
