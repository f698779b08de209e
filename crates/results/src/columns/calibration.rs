//! Columns of the tables of a calibration.

use super::specs;
use crate::ColumnSpec;

/// Columns of `calibration.parquet`: a row for each reading.
pub const CALIBRATION: &[ColumnSpec] = specs! {
    "case": Words, "The case whose string was in the hole";
    "place": Words, "Place of the reading in its file";
    "reading": Words, "`pick_up`, `slack_off`, `rotating`, `torque` or `torque_on_bottom`";
    "used": Ratio, "1 where the reading took part in the fit, 0 where it is only compared with it";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "measured_N": Force, "Measured weight, block included; `null` for torques",
        null_where "it is a torque";
    "predicted_N": Force,
        "Weight by the model with the fitted numbers, block included; `null` for torques",
        null_where "it is a torque";
    "residual_N": Force, "Measured less predicted; `null` for torques", null_where "it is a torque";
    "predicted_error_N": Force,
        "Standard error of the prediction by those of the fitted numbers; `null` for torques",
        null_where "it is a torque";
    "reading_low_N": Force, "Lower end of the band of readings; `null` for torques",
        null_where "it is a torque";
    "reading_high_N": Force, "Its upper end; `null` for torques", null_where "it is a torque";
    "measured_N_m": Torque, "Measured torque; `null` for weights", null_where "it is a weight";
    "predicted_N_m": Torque, "Torque by the model with the fitted numbers; `null` for weights",
        null_where "it is a weight";
    "residual_N_m": Torque, "Measured less predicted; `null` for weights",
        null_where "it is a weight";
    "predicted_error_N_m": Torque,
        "Standard error of the prediction by those of the fitted numbers; `null` for weights",
        null_where "it is a weight";
    "reading_low_N_m": Torque, "Lower end of the band of readings; `null` for weights",
        null_where "it is a weight";
    "reading_high_N_m": Torque, "Its upper end; `null` for weights", null_where "it is a weight";
    "standardised": Ratio, "Measured less predicted, over its standard error after the fit";
    "outlier": Ratio, "1 where that is beyond the bound of outliers, 0 otherwise";
    "within_band": Ratio, "1 where the reading is within the band of readings, 0 otherwise";
};

/// Columns of `calibration_bands.parquet`: a row for each kind of reading at each depth.
pub const CALIBRATION_BANDS: &[ColumnSpec] = specs! {
    "case": Words, "The case whose string is in the hole";
    "reading": Words, "As in `calibration.parquet`";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "predicted_N": Force, "Predicted weight, block included; `null` for torques",
        null_where "it is a torque";
    "mean_low_N": Force, "Lower end of the band of the mean; `null` for torques",
        null_where "it is a torque";
    "mean_high_N": Force, "Its upper end; `null` for torques", null_where "it is a torque";
    "reading_low_N": Force, "Lower end of the band of readings; `null` for torques",
        null_where "it is a torque";
    "reading_high_N": Force, "Its upper end; `null` for torques", null_where "it is a torque";
    "predicted_N_m": Torque, "Predicted torque; `null` for weights", null_where "it is a weight";
    "mean_low_N_m": Torque, "Lower end of the band of the mean; `null` for weights",
        null_where "it is a weight";
    "mean_high_N_m": Torque, "Its upper end; `null` for weights", null_where "it is a weight";
    "reading_low_N_m": Torque, "Lower end of the band of readings; `null` for weights",
        null_where "it is a weight";
    "reading_high_N_m": Torque, "Its upper end; `null` for weights", null_where "it is a weight";
};

/// Columns of `calibration_dynamic.parquet`: a row for each reading that was compared with a
/// dynamic run with the fitted numbers.
pub const CALIBRATION_DYNAMIC: &[ColumnSpec] = specs! {
    "case": Words, "The case whose string was in the hole";
    "place": Words, "Place of the reading in its file";
    "reading": Words, "As in `calibration.parquet`";
    "bit_depth_m": Depth, "Measured depth of the bit at the reading";
    "mean_bit_depth_m": Depth, "Mean of the same in the dynamic run; `null` without an answer",
        null_where "there is no answer";
    "measured_N": Force, "Measured weight, block included; `null` for torques",
        null_where "it is a torque";
    "predicted_N": Force, "The same by the model of the fit; `null` for torques",
        null_where "it is a torque";
    "dynamic_N": Force,
        "Mean by the dynamics, block included; `null` for torques and without an answer",
        null_where "it is a torque, or there is no answer";
    "dynamic_std_N": Force, "Standard deviation against time; `null` as the mean",
        null_where "it is a torque, or there is no answer";
    "measured_N_m": Torque, "Measured torque; `null` for weights", null_where "it is a weight";
    "predicted_N_m": Torque, "The same by the model of the fit; `null` for weights",
        null_where "it is a weight";
    "dynamic_N_m": Torque, "Mean by the dynamics; `null` for weights and without an answer",
        null_where "it is a weight, or there is no answer";
    "dynamic_std_N_m": Torque, "Standard deviation against time; `null` as the mean",
        null_where "it is a weight, or there is no answer";
    "steady": Words,
        "Whether the string had settled: `yes` or `no`; empty where the case gives the start of \
         the window, or there is no answer",
        null_where "the case gives the start of the window, or there is no answer";
    "message": Words, "Reason why there is no answer; else empty", null_where "there is an answer";
};
