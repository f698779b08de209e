//! Peaks on a plan's page.

use wholestring_plan::dynamic::Event;
use wholestring_report::{PlanEvent, PlanPeakRow};
use wholestring_results::{PlanPeak, PlanPeakOf, PlanSummary, Table};

/// Every event with its samples.
pub(super) fn events(summary: &PlanSummary, samples: &Table) -> Vec<PlanEvent> {
    summary.peaks.iter().map(|peak| event(peak, samples)).collect()
}

fn event(peak: &PlanPeak, samples: &Table) -> PlanEvent {
    let rows = rows(peak, samples);
    let column = |name: &str| {
        let values = samples.numbers(name).unwrap_or_default();
        rows.iter().map(|row| values[*row].unwrap_or(f64::NAN)).collect::<Vec<f64>>()
    };
    let peaks = [
        ("hook load", "force", peak.hook_load_N),
        ("surface torque", "torque", peak.surface_torque_N_m),
        ("pump pressure", "pressure", peak.pump_pressure_Pa),
    ];
    let row = |(quantity, dimension, peak): (&'static str, &str, Option<PlanPeakOf>)| {
        let PlanPeakOf { at_rest, peak, time_s, steady, drift: _, ratio, overshoot } = peak?;
        Some(PlanPeakRow {
            quantity,
            dimension: dimension.to_owned(),
            at_rest,
            peak,
            time_s,
            steady,
            ratio: ratio.unwrap_or(f64::NAN),
            overshoot: overshoot.unwrap_or(f64::NAN),
        })
    };
    PlanEvent {
        name: Event::from_name(&peak.event)
            .map_or_else(|| peak.event.clone(), |event| event.label().to_owned()),
        level: peak.friction as usize,
        bit_depth_m: peak.bit_depth_m,
        peaks: peaks.into_iter().filter_map(row).collect(),
        gel_Pa: peak.gel.map(|gel| gel.bore_Pa + gel.annulus_Pa),
        gel_lift_N: peak.gel.map_or(f64::NAN, |gel| gel.lift_N),
        time_s: column("time_s"),
        hook_load_N: column("hook_load_N"),
        torque_N_m: column("surface_torque_N_m"),
        pump_Pa: column("pump_pressure_Pa"),
        message: peak.message.clone(),
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
