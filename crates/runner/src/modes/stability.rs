//! The map of torsional stability of a case that drills.

use std::{borrow::Cow, num::NonZeroUsize, sync::Mutex};

use wholestring::{
    model::Model,
    operation::{Operation, OperationKind},
    well::{Hole, Well},
};
use wholestring_case::Case;
use wholestring_results::StabilitySummary;
use wholestring_vibration::torsional_stability::{
    StabilityError, StabilityLine, StabilityRange, StabilitySettings, Threshold, TorsionalStability,
};

use crate::{
    cancellation::CancellationToken,
    parallel::{in_parallel, jobs, lock},
};

/// Numbers of rotary speeds and weights of the map.
const SPEEDS: usize = 20;
const WEIGHTS: usize = 19;

/// The map of a case, and its result for the case's own speed and weight.
pub(super) struct Stability {
    pub(super) summary: StabilitySummary,
    pub(super) lines: Vec<StabilityLine>,
}

/// Computes the map of an operation that drills, or else of the case's first that does. Returns the
/// reason if there is none: no operation rotates on bottom, the bit is on solid rock, or settings
/// of the dynamics are invalid. After a cancellation the map is invalid.
pub(super) fn find(
    case: &Case,
    operation: &Operation,
    jobs: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> Result<Stability, String> {
    let drills = |operation: &&Operation| operation.kind == OperationKind::Drill;
    let operation = [operation].into_iter().chain(&case.operations).find(drills);
    let found = operation.map(|operation| map(case, operation, jobs, cancellation));
    found.unwrap_or(Err(StabilityError::NotDrilling)).map_err(|error| error.to_string())
}

fn map(
    case: &Case,
    operation: &Operation,
    requested: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> Result<Stability, StabilityError> {
    let settings = settings(case);
    let model = with_static_friction(&case.model, case.modes.static_over_kinetic);
    let string = TorsionalStability::new(&model, operation, &case.dynamics)?;
    let of_case = string.of_case(&settings)?;
    let weights = settings.weights_N.values();
    let lines: Vec<Mutex<Option<Result<StabilityLine, StabilityError>>>> =
        weights.iter().map(|_| Mutex::new(None)).collect();
    let order: Vec<usize> = (0..weights.len()).collect();
    in_parallel(jobs(requested), &order, |index| {
        if !cancellation.is_cancelled() {
            *lock(&lines[index]) = Some(string.line(weights[index], &settings));
        }
    });
    let lines: Result<Vec<StabilityLine>, StabilityError> =
        lines.iter().filter_map(|line| lock(line).take()).collect();
    let lines = lines?;
    // A map that could not have any other result would be misleading.
    let stable = |line: &StabilityLine| line.threshold == Threshold::Everywhere;
    let falls = string.anything_falls()?;
    if lines.iter().all(stable) && of_case.threshold == Threshold::Everywhere && !falls {
        return Err(string.nothing_falls());
    }
    let summary = StabilitySummary::new(&of_case, settings.highest_Hz);
    let summary = StabilitySummary { driven_by_rate: !falls, ..summary };
    Ok(Stability { summary, lines })
}

/// The model with static friction at this ratio to kinetic friction, in sections without higher
/// static friction.
fn with_static_friction(model: &Model, ratio: f64) -> Cow<'_, Model> {
    let hole = &model.well.hole;
    let sections = hole.sections().iter().map(|section| {
        let mut section = *section;
        let friction = &mut section.friction;
        if friction.at_rest <= friction.kinetic {
            friction.at_rest = ratio * friction.kinetic;
        }
        section
    });
    let hole_of = |sections| Hole::new(sections)?.with_roughness(hole.roughness().copied());
    match hole_of(sections.collect()) {
        Ok(hole) if ratio > 1.0 => {
            let path = model.well.path.clone();
            Cow::Owned(Model { well: Well { path, hole }, ..model.clone() })
        }
        _ => Cow::Borrowed(model),
    }
}

/// Ranges of the map.
fn settings(case: &Case) -> StabilitySettings {
    let range = |[from, to]: [f64; 2], values: usize| StabilityRange { from, to, values };
    let [slowest, fastest] = case.modes.rotary_rad_per_s;
    StabilitySettings {
        // A string at zero speed has no steady rotation.
        speeds_rad_per_s: range([slowest.max(fastest / SPEEDS as f64), fastest], SPEEDS),
        weights_N: range(case.modes.weights_N, WEIGHTS),
        highest_Hz: case.modes.highest_frequency_Hz,
    }
}
