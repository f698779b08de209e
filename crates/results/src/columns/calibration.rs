//! Columns of the tables of a calibration.

use super::specs;
use crate::ColumnSpec;

/// Columns of `calibration.parquet`: a row for each number that was read.
pub const CALIBRATION: &[ColumnSpec] = specs! {
    "case": Words, "The case that was in the hole";
    "place": Words, "Where the reading stands in its file";
    "reading": Words, "`pick_up`, `slack_off`, `rotating`, `torque` or `torque_on_bottom`";
    "used": Ratio, "1 where the numbers were found from it, 0 where it is only held against them";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "measured_N": Force, "Weight as it was read, block included; `null` of torques",
        null_where "it is a torque";
    "predicted_N": Force, "Weight by the model with the numbers found, block included; `null` of torques",
        null_where "it is a torque";
    "residual_N": Force, "Measured less predicted; `null` of torques", null_where "it is a torque";
    "predicted_error_N": Force, "Standard error of the prediction by those of the numbers found; `null` of torques",
        null_where "it is a torque";
    "reading_low_N": Force, "Lower end of the band in which a reading lies; `null` of torques",
        null_where "it is a torque";
    "reading_high_N": Force, "Its upper end; `null` of torques", null_where "it is a torque";
    "measured_N_m": Torque, "Torque as it was read; `null` of weights", null_where "it is a weight";
    "predicted_N_m": Torque, "Torque by the model with the numbers found; `null` of weights",
        null_where "it is a weight";
    "residual_N_m": Torque, "Measured less predicted; `null` of weights", null_where "it is a weight";
    "predicted_error_N_m": Torque, "Standard error of the prediction by those of the numbers found; `null` of weights",
        null_where "it is a weight";
    "reading_low_N_m": Torque, "Lower end of the band in which a reading lies; `null` of weights",
        null_where "it is a weight";
    "reading_high_N_m": Torque, "Its upper end; `null` of weights", null_where "it is a weight";
    "standardised": Ratio, "Measured less predicted, over the standard error that it has after the fit";
    "outlier": Ratio, "1 where that is beyond the bound of outliers, 0 otherwise";
    "within_band": Ratio, "1 where the reading lies in the band of readings, 0 otherwise";
};

/// Columns of `calibration_bands.parquet`: a row for each reading that might be made at each depth.
pub const CALIBRATION_BANDS: &[ColumnSpec] = specs! {
    "case": Words, "The case that is in the hole";
    "reading": Words, "As in `calibration.parquet`";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "predicted_N": Force, "Weight that is predicted, block included; `null` of torques",
        null_where "it is a torque";
    "mean_low_N": Force, "Lower end of the band of the mean; `null` of torques", null_where "it is a torque";
    "mean_high_N": Force, "Its upper end; `null` of torques", null_where "it is a torque";
    "reading_low_N": Force, "Lower end of the band of readings; `null` of torques",
        null_where "it is a torque";
    "reading_high_N": Force, "Its upper end; `null` of torques", null_where "it is a torque";
    "predicted_N_m": Torque, "Torque that is predicted; `null` of weights", null_where "it is a weight";
    "mean_low_N_m": Torque, "Lower end of the band of the mean; `null` of weights",
        null_where "it is a weight";
    "mean_high_N_m": Torque, "Its upper end; `null` of weights", null_where "it is a weight";
    "reading_low_N_m": Torque, "Lower end of the band of readings; `null` of weights",
        null_where "it is a weight";
    "reading_high_N_m": Torque, "Its upper end; `null` of weights", null_where "it is a weight";
};

/// Columns of `calibration_profiles.parquet`: a row for each value at which a parameter was held.
pub const CALIBRATION_PROFILES: &[ColumnSpec] = specs! {
    "parameter": Words, "As in the summary: `friction_cased`, `block_weight_N`, ...";
    "value": Ratio, "What it is held at, in the unit that its name ends with";
    "excess": Ratio, "How much greater the sum of squared residuals is than at its least";
    "parabola": Ratio, "What it would be by the standard error alone";
};

/// Columns of `calibration_dynamic.parquet`: a row for each reading that the string in motion was held
/// against, with the numbers that were found.
pub const CALIBRATION_DYNAMIC: &[ColumnSpec] = specs! {
    "case": Words, "The case that was in the hole";
    "place": Words, "Where the reading stands in its file";
    "reading": Words, "As in `calibration.parquet`";
    "bit_depth_m": Depth, "Measured depth of the bit where the reading was made";
    "mean_bit_depth_m": Depth, "The same of the string in motion, on average; `null` without an answer",
        null_where "there is no answer";
    "measured_N": Force, "Weight as it was read, block included; `null` of torques",
        null_where "it is a torque";
    "predicted_N": Force, "The same by the model that the numbers were found with; `null` of torques",
        null_where "it is a torque";
    "dynamic_N": Force, "Mean by the dynamics, block included; `null` of torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "dynamic_std_N": Force, "Standard deviation against time; `null` as the mean",
        null_where "it is a torque, or there is no answer";
    "measured_N_m": Torque, "Torque as it was read; `null` of weights", null_where "it is a weight";
    "predicted_N_m": Torque, "The same by the model that the numbers were found with; `null` of weights",
        null_where "it is a weight";
    "dynamic_N_m": Torque, "Mean by the dynamics; `null` of weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "dynamic_std_N_m": Torque, "Standard deviation against time; `null` as the mean",
        null_where "it is a weight, or there is no answer";
    "steady": Words, "Whether the string had settled: `yes` or `no`; empty where the case says when, or there \
                      is no answer",
        null_where "the case says when, or there is no answer";
    "message": Words, "Why there is no answer; else empty", null_where "there is an answer";
};
