//! Rows of the tables of a calibration.

use serde::{Deserialize, Serialize};

use crate::row::rows;

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
        is_torque = |row| row.is_torque(), loads {
            measured: f64, "Measured weight, block included" | "Measured torque";
            predicted: f64,
                "Weight by the model with the fitted numbers, block included"
                | "Torque by the model with the fitted numbers";
            residual: f64, "Measured less predicted";
            predicted_error: f64,
                "Standard error of the prediction by those of the fitted numbers";
            reading_low: f64, "Lower end of the band of readings";
            reading_high: f64, "Its upper end";
        };
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
        is_torque = |row| row.is_torque(), loads {
            predicted: f64, "Predicted weight, block included" | "Predicted torque";
            mean_low: f64, "Lower end of the band of the mean";
            mean_high: f64, "Its upper end";
            reading_low: f64, "Lower end of the band of readings";
            reading_high: f64, "Its upper end";
        };
    }

    /// Columns of `calibration_bands.parquet`: a row for each kind of reading at each depth.
    pub const CALIBRATION_BANDS, read;
}

/// Whether readings of this name are torques rather than weights.
fn is_torque(reading: &str) -> bool {
    reading.starts_with("torque")
}

impl CalibrationReading {
    /// Whether it is a torque rather than a weight.
    pub fn is_torque(&self) -> bool {
        is_torque(&self.reading)
    }
}

impl CalibrationBand {
    /// Whether it is of torques rather than of weights.
    pub fn is_torque(&self) -> bool {
        is_torque(&self.reading)
    }
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
        is_torque = |check| check.is_torque, loads {
            measured = |check| check.measured,
                "Measured weight, block included" | "Measured torque";
            predicted = |check| check.predicted, "The same by the model of the fit";
            dynamic = |check| check.mean(),
                "Mean by the dynamics, block included" | "Mean by the dynamics", unanswered;
            dynamic_std = |check| check.std(),
                "Standard deviation against time", unanswered "as the mean";
        };
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
