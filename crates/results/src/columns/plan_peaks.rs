//! Columns of the peaks of a plan.

use crate::ColumnSpec;

/// Columns of `plan_peaks.parquet`: hook load, torque and pump pressure of a string that is set in
/// motion from rest, by the dynamics; a row for each event, friction and depth of the bit.
pub const PLAN_PEAKS: &[ColumnSpec] = super::specs! {
    "event": Words,
        "`pick_up_from_slips`, `slack_off_from_slips`, `break_circulation` or `break_rotation`";
    "friction": Words, "`low`, `expected` or `high`";
    "bit_depth_m": Depth, "Measured depth of the bit";
    "hook_load_at_rest_N": Force,
        "Hook load before, block and top drive excluded; this and the other columns of the hook \
         load are `null` where there is no answer",
        null_where "there is no answer";
    "hook_load_peak_N": Force, "Sample farthest from that, or `null`",
        null_where "there is no answer";
    "hook_load_peak_time_s": Time, "Time of the peak, from the beginning of the event, or `null`",
        null_where "there is no answer";
    "hook_load_steady_N": Force,
        "Final value: the mean over the last quarter of the observed time, or `null`",
        null_where "there is no answer";
    "hook_load_drift_N": Force, "That less the mean over the quarter before, or `null`",
        null_where "there is no answer";
    "hook_load_ratio": Ratio, "Peak over final value, or `null`",
        null_where "there is no answer, or the final value is zero";
    "hook_load_overshoot": Ratio,
        "Excess of the peak over the final value, as a part of the change, or `null`",
        null_where "there is no answer, or nothing changes";
    "surface_torque_peak_N_m": Torque,
        "Peak of the surface torque; this and its other columns are `null` where the string does \
         not turn",
        null_where "the string does not turn";
    "surface_torque_peak_time_s": Time, "Time of the peak, or `null`",
        null_where "the string does not turn";
    "surface_torque_steady_N_m": Torque, "Final value, or `null`",
        null_where "the string does not turn";
    "surface_torque_ratio": Ratio, "Peak over final value, or `null`",
        null_where "the string does not turn";
    "pump_pressure_peak_Pa": Pressure,
        "Peak of the pump's pressure, without its gel; this and its other columns are `null` \
         where no pump starts",
        null_where "no pump starts";
    "pump_pressure_peak_time_s": Time, "Time of the peak, or `null`", null_where "no pump starts";
    "pump_pressure_steady_Pa": Pressure, "Final value, or `null`", null_where "no pump starts";
    "pump_pressure_ratio": Ratio, "Peak over final value, or `null`", null_where "no pump starts";
    "gel_bore_Pa": Pressure,
        "Pressure that breaks the gel in the bore; this and the following are `null` without a \
         gel strength",
        null_where "no pump starts, or the gel strength is not known";
    "gel_annulus_Pa": Pressure, "The same in the annulus, or `null`",
        null_where "no pump starts, or the gel strength is not known";
    "gel_lift_N": Force, "Reduction of the hook load as the gel in the annulus breaks, or `null`",
        null_where "no pump starts, or the gel strength is not known";
    "message": Words, "Reason why there is no answer, or a warning; else empty",
        null_where "there is no message";
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
    "flow_rate_m3_per_s": FlowRate, "Flow rate of the pumps";
};
