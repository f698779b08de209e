//! Columns of the peaks of a plan.

use crate::ColumnSpec;

/// Columns of `plan_peaks.parquet`: what a string that sets itself in motion from rest makes of hook load, torque
/// and pump pressure, a row for each event, friction and depth of the bit, by the dynamics.
pub const PLAN_PEAKS: &[ColumnSpec] = super::specs! {
    "event": Words, "`pick_up_from_slips`, `slack_off_from_slips`, `break_circulation` or `break_rotation`";
    "friction": Words, "`low`, `expected` or `high`";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "hook_load_at_rest_N": Force,
        "Hook load before, block and top drive excluded; this and the others of the hook load are `null` where \
         there is no answer",
        null_where "there is no answer";
    "hook_load_peak_N": Force, "Farthest from that at any sample, or `null`",
        null_where "there is no answer";
    "hook_load_peak_time_s": Time, "When, from the beginning of the event, or `null`",
        null_where "there is no answer";
    "hook_load_steady_N": Force, "What it comes to: the mean over the last quarter of the watch, or `null`",
        null_where "there is no answer";
    "hook_load_drift_N": Force, "That less the mean over the quarter before, or `null`",
        null_where "there is no answer";
    "hook_load_ratio": Ratio, "Peak over what it comes to, or `null`",
        null_where "there is no answer, or it comes to nothing";
    "hook_load_overshoot": Ratio,
        "How far the peak goes beyond what it comes to, as a part of the change, or `null`",
        null_where "there is no answer, or nothing changes";
    "surface_torque_peak_N_m": Torque,
        "The same of the surface torque; this and the others of it are `null` where the string does not turn",
        null_where "the string does not turn";
    "surface_torque_peak_time_s": Time, "When, or `null`", null_where "the string does not turn";
    "surface_torque_steady_N_m": Torque, "What it comes to, or `null`",
        null_where "the string does not turn";
    "surface_torque_ratio": Ratio, "Peak over what it comes to, or `null`",
        null_where "the string does not turn";
    "pump_pressure_peak_Pa": Pressure,
        "The same of the pump's pressure, its gel apart; this and the others of it are `null` where no pump \
         starts",
        null_where "no pump starts";
    "pump_pressure_peak_time_s": Time, "When, or `null`", null_where "no pump starts";
    "pump_pressure_steady_Pa": Pressure, "What it comes to, or `null`", null_where "no pump starts";
    "pump_pressure_ratio": Ratio, "Peak over what it comes to, or `null`", null_where "no pump starts";
    "gel_bore_Pa": Pressure,
        "Pressure that breaks the gel in the bore; this and what follows `null` without a gel strength",
        null_where "no pump starts, or the gel strength is not known";
    "gel_annulus_Pa": Pressure, "In the annulus, or `null`",
        null_where "no pump starts, or the gel strength is not known";
    "gel_lift_N": Force, "What the gel in the annulus takes off the hook load as it breaks, or `null`",
        null_where "no pump starts, or the gel strength is not known";
    "message": Words, "Why there is no answer, or a warning; else empty",
        null_where "there is nothing to say";
};

/// Columns of `plan_peaks_time.parquet`: the same events against time, a row for each sample.
pub const PLAN_PEAKS_TIME: &[ColumnSpec] = super::specs! {
    "event": Words, "`pick_up_from_slips`, `break_circulation`, ...";
    "friction": Words, "`low`, `expected` or `high`";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "time_s": Time, "Time from the beginning of the event";
    "hook_load_N": Force, "Hook load, block and top drive excluded";
    "surface_torque_N_m": Torque, "Torque at the top of the string";
    "pump_pressure_Pa": Pressure, "Pressure of the pump; `null` without a rheology",
        null_where "the mud has no rheology";
    "block_velocity_m_per_s": Speed, "Speed of the block; positive downwards";
    "rotary_speed_rad_per_s": RotarySpeed, "Rotary speed at surface";
    "flow_rate_m3_per_s": FlowRate, "What the pumps deliver";
};
