//! Time histories of a string that is set in motion.

use wholestring_results::{PlanPeak, PlanPeakSample};

/// Samples of an event.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct History {
    /// Time from its beginning, s.
    pub(super) time_s: Vec<f64>,
    /// Hook load without block, N.
    pub(super) hook_load_N: Vec<f64>,
    /// Surface torque, N·m.
    pub(super) surface_torque_N_m: Vec<f64>,
    /// Pressure of the pump, Pa; not a number without a rheology.
    pub(super) pump_pressure_Pa: Vec<f64>,
}

/// The history of each peak in the samples of all events.
pub(super) fn histories(peaks: &[PlanPeak], samples: &[PlanPeakSample]) -> Vec<History> {
    peaks.iter().map(|peak| history(peak, samples)).collect()
}

fn history(peak: &PlanPeak, samples: &[PlanPeakSample]) -> History {
    let is_its = |sample: &&PlanPeakSample| {
        sample.event == peak.event
            && sample.friction == peak.friction
            && sample.bit_depth_m == peak.bit_depth_m
    };
    let own: Vec<&PlanPeakSample> = samples.iter().filter(is_its).collect();
    let column =
        |value: fn(&PlanPeakSample) -> f64| own.iter().map(|sample| value(sample)).collect();
    History {
        time_s: column(|sample| sample.time_s),
        hook_load_N: column(|sample| sample.hook_load_N),
        surface_torque_N_m: column(|sample| sample.surface_torque_N_m),
        pump_pressure_Pa: column(|sample| sample.pump_pressure_Pa),
    }
}
