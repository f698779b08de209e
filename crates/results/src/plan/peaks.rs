//! Peaks of a string that is set in motion from rest, by the dynamics of a plan.

use serde::{Deserialize, Serialize};
use wholestring::well::FrictionLevel;

use crate::{Row, Table, columns::FRICTION, row::rows};

/// Declares the row of an event: quantities that start with it have the same columns.
macro_rules! peaks {
    ($(
        $quantity:ident: $name:literal $unit:literal $kind:ident, $title:literal, $meaning:literal,
        null_where $none:literal;
    )+) => {
        rows! {
            /// An event with the bit at one depth and one friction.
            #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
            pub struct PlanPeak {
                event: String => Words,
                    "`pick_up_from_slips`, `slack_off_from_slips`, `break_circulation` or \
                     `break_rotation`";
                friction: FrictionLevel => Words as FRICTION, "Level of friction";
                bit_depth_m: f64 => Depth, "Measured depth of the bit";
                hook_load_N: Option<PlanPeakOf>,
                    "Peak of the hook load without block, N; none where there is no answer",
                    columns {
                        hook_load_at_rest_N = |peak| peak.at_rest => Force,
                            "Hook load before, block and top drive excluded; this and the other \
                             columns of the hook load are `null` where there is no answer",
                            null_where "there is no answer";
                        hook_load_peak_N = |peak| peak.peak => Force,
                            "Sample farthest from that, or `null`",
                            null_where "there is no answer";
                        hook_load_peak_time_s = |peak| peak.time_s => Time,
                            "Time of the peak, from the beginning of the event, or `null`",
                            null_where "there is no answer";
                        hook_load_steady_N = |peak| peak.steady => Force,
                            "Final value: the mean over the last quarter of the observed time, or \
                             `null`",
                            null_where "there is no answer";
                        hook_load_drift_N = |peak| peak.drift => Force,
                            "That less the mean over the quarter before, or `null`",
                            null_where "there is no answer";
                        hook_load_ratio = |peak| peak.ratio => Ratio,
                            "Peak over final value, or `null`",
                            null_where "there is no answer, or the final value is zero";
                        hook_load_overshoot = |peak| peak.overshoot => Ratio,
                            "Excess of the peak over the final value, as a part of the change, or \
                             `null`",
                            null_where "there is no answer, or nothing changes";
                    };
                $(
                    $quantity: Option<PlanPeakOf>, $meaning, columns {
                        [$name "_peak_" $unit] = |peak| peak.peak => $kind,
                            concat!(
                                "Peak of the ", $title,
                                "; this and its other columns are `null` where ", $none,
                            ),
                            null_where $none;
                        [$name "_peak_time_s"] = |peak| peak.time_s => Time,
                            "Time of the peak, or `null`",
                            null_where $none;
                        [$name "_steady_" $unit] = |peak| peak.steady => $kind,
                            "Final value, or `null`",
                            null_where $none;
                        [$name "_ratio"] = |peak| peak.ratio => Ratio,
                            "Peak over final value, or `null`",
                            null_where $none;
                    };
                )+
                gel: Option<PlanGel>,
                    "Pressures that break the gel; none where its strength is not known",
                    columns {
                        gel_bore_Pa = |gel| gel.bore_Pa => Pressure,
                            "Pressure that breaks the gel in the bore; this and the following are \
                             `null` without a gel strength",
                            null_where "no pump starts, or the gel strength is not known";
                        gel_annulus_Pa = |gel| gel.annulus_Pa => Pressure,
                            "The same in the annulus, or `null`",
                            null_where "no pump starts, or the gel strength is not known";
                        gel_lift_N = |gel| gel.lift_N => Force,
                            "Reduction of the hook load as the gel in the annulus breaks, or \
                             `null`",
                            null_where "no pump starts, or the gel strength is not known";
                    };
                message: Option<String> => Words,
                    "Reason why there is no answer, or a warning; else empty",
                    null_where "there is no message";
            }

            /// Columns of `plan_peaks.parquet`: hook load, torque and pump pressure of a string
            /// that is set in motion from rest, by the dynamics; a row for each event, friction and
            /// depth of the bit.
            pub const PLAN_PEAKS;
        }
    };
}

peaks! {
    surface_torque_N_m: "surface_torque" "N_m" Torque, "surface torque",
        "Peak of the surface torque, N·m; none where nothing turns",
        null_where "the string does not turn";
    pump_pressure_Pa: "pump_pressure" "Pa" Pressure, "pump's pressure, without its gel",
        "Peak of the pump's pressure, Pa; none where no pump starts",
        null_where "no pump starts";
}

/// Response of a quantity to an event, in its unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanPeakOf {
    /// Before the event.
    pub at_rest: f64,
    /// Sample farthest from that.
    pub peak: f64,
    /// Time of the peak, s from the beginning of the event.
    pub time_s: f64,
    /// Final value.
    pub steady: f64,
    /// Change of the final value from a quarter of the observed time to the next.
    pub drift: f64,
    /// Peak over final value; none where that is zero.
    pub ratio: Option<f64>,
    /// Excess of the peak over the final value, as a part of the change; none where nothing
    /// changes.
    pub overshoot: Option<f64>,
}

/// Pressures that break the gel of a mud.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanGel {
    /// Pressure in the bore, Pa.
    pub bore_Pa: f64,
    /// Pressure in the annulus, Pa.
    pub annulus_Pa: f64,
    /// Reduction of the hook load, N.
    pub lift_N: f64,
}

/// An event sample by sample.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlanHistory {
    /// Time from the beginning of the event, s.
    pub time_s: Vec<f64>,
    /// Hook load without block, N.
    pub hook_load_N: Vec<f64>,
    /// Surface torque, N·m.
    pub surface_torque_N_m: Vec<f64>,
    /// Pressure of the pump, Pa; not a number without a rheology.
    pub pump_pressure_Pa: Vec<f64>,
    /// Speed of the block, m/s, positive downwards.
    pub block_velocity_m_per_s: Vec<f64>,
    /// Rotary speed, rad/s.
    pub rotary_speed_rad_per_s: Vec<f64>,
    /// Flow rate of the pumps, m³/s.
    pub flow_rate_m3_per_s: Vec<f64>,
}

rows! {
    /// A sample of an event.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PlanPeakSample {
        event: String => Words, "`pick_up_from_slips`, `break_circulation`, ...";
        friction: FrictionLevel => Words as FRICTION, "Level of friction";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        time_s: f64 => Time, "Time from the beginning of the event";
        hook_load_N: f64 => Force, "Hook load, block and top drive excluded";
        surface_torque_N_m: f64 => Torque, "Torque at the top of the string";
        pump_pressure_Pa: f64 => Pressure, "Pressure of the pump; `null` without a rheology",
            null_where "the mud has no rheology";
        block_velocity_m_per_s: f64 => Speed, "Speed of the block; positive downwards";
        rotary_speed_rad_per_s: f64 => RotarySpeed, "Rotary speed at surface";
        flow_rate_m3_per_s: f64 => FlowRate, "Flow rate of the pumps";
    }

    /// Columns of `plan_peaks_time.parquet`: the same events against time, a row for each sample.
    pub const PLAN_PEAKS_TIME, read;
}

/// A row for each sample of each event.
pub fn plan_peaks_time_table(histories: &[(&PlanPeak, &PlanHistory)]) -> Table {
    let rows = histories.iter().flat_map(|(peak, history)| {
        (0..history.time_s.len()).map(|sample| PlanPeakSample {
            event: peak.event.clone(),
            friction: peak.friction,
            bit_depth_m: peak.bit_depth_m,
            time_s: history.time_s[sample],
            hook_load_N: history.hook_load_N[sample],
            surface_torque_N_m: history.surface_torque_N_m[sample],
            pump_pressure_Pa: history.pump_pressure_Pa[sample],
            block_velocity_m_per_s: history.block_velocity_m_per_s[sample],
            rotary_speed_rad_per_s: history.rotary_speed_rad_per_s[sample],
            flow_rate_m3_per_s: history.flow_rate_m3_per_s[sample],
        })
    });
    PlanPeakSample::table(rows)
}
