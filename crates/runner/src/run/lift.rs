//! Search of the lift of a string that hangs on the hoist.

use wholestring::{
    dynamics::{MAX_TUNING_RUNS, Simulation, TunedHookLoad, TuningError, tune_hook_load},
    operation::Operation,
};
use wholestring_case::Case;

use super::way::Way;
use crate::observer::{Simulating, Trial};

/// Simulated time between two progress reports, s.
const SHOW_INTERVAL_S: f64 = 0.2;

/// Finds the lift of an operation, and its run with it.
pub(super) fn tune(
    case: &Case,
    operation: &Operation,
    way: &Way<'_>,
) -> Result<(TunedHookLoad, Simulation), TuningError> {
    let mut report: Option<(usize, Simulating<'_>)> = None;
    let mut shown_s = f64::NEG_INFINITY;
    let (model, settings) = (&case.model, &case.dynamics);
    tune_hook_load(model, operation, settings, &way.executor, |run, simulation| {
        if report.as_ref().is_none_or(|(trial, _)| *trial != run) {
            let trial = Trial { number: run, most: MAX_TUNING_RUNS };
            let times = [0.0, simulation.end_time_s()];
            // Ends the report of the previous trial.
            report = None;
            let name = operation.kind.name();
            report = Some((run, way.watch.simulation(name, Some(trial), times)));
            shown_s = f64::NEG_INFINITY;
        }
        if let Some((_, report)) = &report
            && simulation.time_s() >= shown_s + SHOW_INTERVAL_S
        {
            shown_s = simulation.time_s();
            let settling = settings.steady.is_some() && simulation.is_settling();
            report.reach(simulation.time_s(), simulation.end_time_s(), settling);
        }
        !way.cancellation.is_cancelled()
    })
}
