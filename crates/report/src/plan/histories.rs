//! Time histories of a string that is set in motion.

use wholestring_results::{PlanPeak, Table};

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
pub(super) fn histories(peaks: &[PlanPeak], samples: &Table) -> Vec<History> {
    peaks.iter().map(|peak| history(peak, samples)).collect()
}

fn history(peak: &PlanPeak, samples: &Table) -> History {
    let rows = rows(peak, samples);
    let column = |name: &str| {
        let values = samples.numbers(name).unwrap_or_default();
        rows.iter().map(|row| values[*row].unwrap_or(f64::NAN)).collect()
    };
    History {
        time_s: column("time_s"),
        hook_load_N: column("hook_load_N"),
        surface_torque_N_m: column("surface_torque_N_m"),
        pump_pressure_Pa: column("pump_pressure_Pa"),
    }
}

/// Rows of an event in the samples of all.
fn rows(peak: &PlanPeak, samples: &Table) -> Vec<usize> {
    let (Some(events), Some(frictions), Some(depths)) =
        (samples.words("event"), samples.words("friction"), samples.numbers("bit_depth_m"))
    else {
        return Vec::new();
    };
    let is_its = |row: &usize| {
        events[*row] == peak.event
            && frictions[*row] == peak.friction.name()
            && depths[*row] == Some(peak.bit_depth_m)
    };
    (0..samples.rows()).filter(is_its).collect()
}
