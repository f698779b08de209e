//! The lift that a string hangs on, found by trial.

use wholestring::{
    dynamics::{MAX_TUNING_RUNS, Simulation, TunedHookLoad, TuningError, tune_hook_load},
    operation::Operation,
};
use wholestring_case::Case;

use super::way::Way;
use crate::observer::{Simulating, Trial};

/// Simulated time between two tellings of the progress, s.
const SHOW_INTERVAL_S: f64 = 0.2;

/// Finds the lift of an operation, and its run under it.
pub(super) fn tune(
    case: &Case,
    operation: &Operation,
    way: &Way<'_>,
) -> Result<(TunedHookLoad, Simulation), TuningError> {
    let mut shown: Option<(usize, Simulating<'_>)> = None;
    let mut shown_s = f64::NEG_INFINITY;
    let (model, settings) = (&case.model, &case.dynamics);
    tune_hook_load(model, operation, settings, &way.executor, |run, simulation| {
        if shown.as_ref().is_none_or(|(of, _)| *of != run) {
            let trial = Trial { number: run, most: MAX_TUNING_RUNS };
            let times = [0.0, simulation.end_time_s()];
            // The one before has ended.
            shown = None;
            let name = operation.kind.name();
            shown = Some((run, way.watch.simulation(name, Some(trial), times)));
            shown_s = f64::NEG_INFINITY;
        }
        if let Some((_, shown)) = &shown
            && simulation.time_s() >= shown_s + SHOW_INTERVAL_S
        {
            shown_s = simulation.time_s();
            let settling = settings.steady.is_some() && simulation.is_settling();
            shown.reach(simulation.time_s(), simulation.end_time_s(), settling);
        }
        !way.cancellation.is_cancelled()
    })
}
