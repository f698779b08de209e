//! Peaks of a string that sets itself in motion, by the dynamics of a plan.

use serde::{Deserialize, Serialize};

use crate::{PLAN_PEAKS, PLAN_PEAKS_TIME, Table};

/// An event with the bit at one depth and one friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanPeak {
    /// `pick_up_from_slips`, `break_circulation`, ...
    pub event: String,
    /// `low`, `expected` or `high`.
    pub friction: String,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Of the hook load without block, N; none where there is no answer.
    pub hook_load_N: Option<PlanPeakOf>,
    /// Of the surface torque, N·m; none where nothing turns.
    pub surface_torque_N_m: Option<PlanPeakOf>,
    /// Of the pump's pressure, Pa; none where no pump starts.
    pub pump_pressure_Pa: Option<PlanPeakOf>,
    /// What breaks the gel; none where its strength is not known.
    pub gel: Option<PlanGel>,
    /// Why there is no answer, or a warning.
    pub message: Option<String>,
}

/// What an event makes of a quantity, in its unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanPeakOf {
    /// Before the event.
    pub at_rest: f64,
    /// Farthest from that.
    pub peak: f64,
    /// When, s from the beginning of the event.
    pub time_s: f64,
    /// What it comes to.
    pub steady: f64,
    /// By how much that still changes from a quarter of the watch to the next.
    pub drift: f64,
    /// Peak over what it comes to; none where that is nothing.
    pub ratio: Option<f64>,
    /// What the peak goes beyond, as a part of the change; none where nothing changes.
    pub overshoot: Option<f64>,
}

/// What breaks the gel of a mud.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanGel {
    /// In the bore, Pa.
    pub bore_Pa: f64,
    /// In the annulus, Pa.
    pub annulus_Pa: f64,
    /// What it takes off the hook load, N.
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
    /// What the pumps deliver, m³/s.
    pub flow_rate_m3_per_s: Vec<f64>,
}

/// A row for each event, friction and depth.
pub fn plan_peaks_table(peaks: &[PlanPeak]) -> Table {
    let mut table = Table::with_columns(PLAN_PEAKS);
    for of in peaks {
        let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
        let part = |of: &Option<PlanPeakOf>, part: fn(&PlanPeakOf) -> Option<f64>| {
            number(of.as_ref().and_then(part))
        };
        let PlanPeak {
            hook_load_N: hook, surface_torque_N_m: torque, pump_pressure_Pa: pump, ..
        } = of;
        let gel = |part: fn(&PlanGel) -> f64| number(of.gel.as_ref().map(part));
        table.append(
            &[
                ("event", &[&of.event]),
                ("friction", &[&of.friction]),
                ("message", &[of.message.as_deref().unwrap_or_default()]),
            ],
            &[
                ("bit_depth_m", &[of.bit_depth_m]),
                ("hook_load_at_rest_N", &part(hook, |of| Some(of.at_rest))),
                ("hook_load_peak_N", &part(hook, |of| Some(of.peak))),
                ("hook_load_peak_time_s", &part(hook, |of| Some(of.time_s))),
                ("hook_load_steady_N", &part(hook, |of| Some(of.steady))),
                ("hook_load_drift_N", &part(hook, |of| Some(of.drift))),
                ("hook_load_ratio", &part(hook, |of| of.ratio)),
                ("hook_load_overshoot", &part(hook, |of| of.overshoot)),
                ("surface_torque_peak_N_m", &part(torque, |of| Some(of.peak))),
                ("surface_torque_peak_time_s", &part(torque, |of| Some(of.time_s))),
                ("surface_torque_steady_N_m", &part(torque, |of| Some(of.steady))),
                ("surface_torque_ratio", &part(torque, |of| of.ratio)),
                ("pump_pressure_peak_Pa", &part(pump, |of| Some(of.peak))),
                ("pump_pressure_peak_time_s", &part(pump, |of| Some(of.time_s))),
                ("pump_pressure_steady_Pa", &part(pump, |of| Some(of.steady))),
                ("pump_pressure_ratio", &part(pump, |of| of.ratio)),
                ("gel_bore_Pa", &gel(|of| of.bore_Pa)),
                ("gel_annulus_Pa", &gel(|of| of.annulus_Pa)),
                ("gel_lift_N", &gel(|of| of.lift_N)),
            ],
        );
    }
    table
}

/// A row for each sample of each event.
pub fn plan_peaks_time_table(histories: &[(&PlanPeak, &PlanHistory)]) -> Table {
    let mut table = Table::with_columns(PLAN_PEAKS_TIME);
    for (of, history) in histories {
        let rows = history.time_s.len();
        table.append(
            &[("event", &[&of.event]), ("friction", &[&of.friction])],
            &[
                ("bit_depth_m", &vec![of.bit_depth_m; rows]),
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
