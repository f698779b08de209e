//! Peaks of a string that is set in motion from rest, by the dynamics of a plan.

use serde::{Deserialize, Serialize};
use wholestring::well::FrictionLevel;

use crate::{PLAN_PEAKS, PLAN_PEAKS_TIME, Table};

/// An event with the bit at one depth and one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanPeak {
    /// `pick_up_from_slips`, `break_circulation`, ...
    pub event: String,
    /// Level of friction.
    pub friction: FrictionLevel,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Peak of the hook load without block, N; none where there is no answer.
    pub hook_load_N: Option<PlanPeakOf>,
    /// Peak of the surface torque, N·m; none where nothing turns.
    pub surface_torque_N_m: Option<PlanPeakOf>,
    /// Peak of the pump's pressure, Pa; none where no pump starts.
    pub pump_pressure_Pa: Option<PlanPeakOf>,
    /// Pressures that break the gel; none where its strength is not known.
    pub gel: Option<PlanGel>,
    /// Reason why there is no answer, or a warning.
    pub message: Option<String>,
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

/// A row for each event, friction and depth.
pub fn plan_peaks_table(peaks: &[PlanPeak]) -> Table {
    let mut table = Table::with_columns(PLAN_PEAKS);
    for peak in peaks {
        let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
        let part = |plan_peak_of: &Option<PlanPeakOf>, part: fn(&PlanPeakOf) -> Option<f64>| {
            number(plan_peak_of.as_ref().and_then(part))
        };
        let PlanPeak {
            hook_load_N: hook, surface_torque_N_m: torque, pump_pressure_Pa: pump, ..
        } = peak;
        let gel = |part: fn(&PlanGel) -> f64| number(peak.gel.as_ref().map(part));
        table.append(
            &[
                ("event", &[&peak.event]),
                ("friction", &[peak.friction.name()]),
                ("message", &[peak.message.as_deref().unwrap_or_default()]),
            ],
            &[
                ("bit_depth_m", &[peak.bit_depth_m]),
                ("hook_load_at_rest_N", &part(hook, |peak| Some(peak.at_rest))),
                ("hook_load_peak_N", &part(hook, |peak| Some(peak.peak))),
                ("hook_load_peak_time_s", &part(hook, |peak| Some(peak.time_s))),
                ("hook_load_steady_N", &part(hook, |peak| Some(peak.steady))),
                ("hook_load_drift_N", &part(hook, |peak| Some(peak.drift))),
                ("hook_load_ratio", &part(hook, |peak| peak.ratio)),
                ("hook_load_overshoot", &part(hook, |peak| peak.overshoot)),
                ("surface_torque_peak_N_m", &part(torque, |peak| Some(peak.peak))),
                ("surface_torque_peak_time_s", &part(torque, |peak| Some(peak.time_s))),
                ("surface_torque_steady_N_m", &part(torque, |peak| Some(peak.steady))),
                ("surface_torque_ratio", &part(torque, |peak| peak.ratio)),
                ("pump_pressure_peak_Pa", &part(pump, |peak| Some(peak.peak))),
                ("pump_pressure_peak_time_s", &part(pump, |peak| Some(peak.time_s))),
                ("pump_pressure_steady_Pa", &part(pump, |peak| Some(peak.steady))),
                ("pump_pressure_ratio", &part(pump, |peak| peak.ratio)),
                ("gel_bore_Pa", &gel(|gel| gel.bore_Pa)),
                ("gel_annulus_Pa", &gel(|gel| gel.annulus_Pa)),
                ("gel_lift_N", &gel(|gel| gel.lift_N)),
            ],
        );
    }
    table
}

/// A row for each sample of each event.
pub fn plan_peaks_time_table(histories: &[(&PlanPeak, &PlanHistory)]) -> Table {
    let mut table = Table::with_columns(PLAN_PEAKS_TIME);
    for (peak, history) in histories {
        let rows = history.time_s.len();
        table.append(
            &[("event", &[&peak.event]), ("friction", &[peak.friction.name()])],
            &[
                ("bit_depth_m", &vec![peak.bit_depth_m; rows]),
                ("time_s", &history.time_s),
                ("hook_load_N", &history.hook_load_N),
                ("surface_torque_N_m", &history.surface_torque_N_m),
                ("pump_pressure_Pa", &history.pump_pressure_Pa),
                ("block_velocity_m_per_s", &history.block_velocity_m_per_s),
                ("rotary_speed_rad_per_s", &history.rotary_speed_rad_per_s),
                ("flow_rate_m3_per_s", &history.flow_rate_m3_per_s),
            ],
        );
    }
    table
}
