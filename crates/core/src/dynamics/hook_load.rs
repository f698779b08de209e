//! A constant lift on the top of the string, found so that the mean weight on bit equals that of
//! the operation.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{
    assemble::SetupError,
    settings::{DynamicsSettings, FrictionLaw, HoistControl},
};
use crate::{
    dynamics::simulation::{Simulation, diverged::Diverged},
    model::Model,
    operation::Operation,
    rock::Executor,
    statics::soft::{self, SoftError, SoftSettings},
};

/// Runs after which the search gives up.
pub const MAX_TUNING_RUNS: usize = 20;

/// A constant lift and the resulting run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TunedHookLoad {
    /// Lifting force on the top of the string, block excluded, N.
    #[serde(with = "crate::finite")]
    pub hook_load_N: f64,
    /// Mean weight on bit over the window that it gives, N.
    #[serde(with = "crate::finite")]
    pub weight_on_bit_N: f64,
    /// Runs of the whole case that it took to find.
    pub runs: usize,
}

/// Why no lift was found.
#[derive(Debug, thiserror::Error)]
pub enum TuningError {
    /// The run cannot begin.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The soft string, which provides the first estimate, has no solution.
    #[error("no lift can be guessed: {0}")]
    Guess(#[from] SoftError),
    /// An operation without weight on bit.
    #[error("{0} puts no weight on the bit that a lift could be tuned for")]
    NoWeight(&'static str),
    /// A run diverged.
    #[error("with a lift of {:.1} kN {diverged}", .hook_load_N * 1e-3)]
    Diverged {
        /// Lift of that run, N.
        hook_load_N: f64,
        /// Details of the divergence.
        diverged: Diverged,
    },
    /// No lift gives the weight on bit.
    #[error(
        "no constant lift gives a mean weight on bit of {:.1} kN over this window: after {} runs \
         the nearest is {:.1} kN \
         under a lift of {:.1} kN; a longer window, or a smoother bit, makes the mean follow the \
         lift more evenly",
        .target_N * 1e-3, .nearest.runs, .nearest.weight_on_bit_N * 1e-3, .nearest.hook_load_N * 1e-3
    )]
    NotFound {
        /// Weight on bit that was requested, N.
        target_N: f64,
        /// The lift that comes nearest, after all runs.
        nearest: TunedHookLoad,
    },
    /// The observer requested a stop.
    #[error("stopped")]
    Stopped,
}

/// Finds the constant lift under which the mean weight on bit over the window is the operation's,
/// within [`DynamicsSettings::lift_tolerance`], and gives back the run with it, finished.
///
/// Each try is the whole run, from its start to the end of its window. The first is the hook load
/// of the soft string; for [`FrictionLaw::Independent`], which drags a string that turns too, the
/// mean of that and of the hook load of one that slides. The second differs by the error of the
/// weight, the next follow the secant through the last two, no step more than twice the one before,
/// until the root is bracketed; between the two ends it is their secant, the end that stays halved
/// each time (the Illinois rule). Where several lifts give the weight, it is the one that this
/// finds: the same on every run, whatever other cases are solved.
///
/// `watch` receives the number of the try, from one, and its run before each sample; the search
/// stops where it answers `false`, or where the `executor`, which works on solid rock under the
/// bit, requests a stop. Where the window begins when the string is steady, each try settles for
/// itself: its mean is that of a string that is steady under its lift.
///
/// # Errors
/// An operation without weight on bit, a run that cannot begin or diverges, and a weight that no
/// lift gives.
pub fn tune_hook_load(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
    executor: &Arc<dyn Executor + Send + Sync>,
    mut watch: impl FnMut(usize, &Simulation) -> bool,
) -> Result<(TunedHookLoad, Simulation), TuningError> {
    let target_N = operation.weight_on_bit_now_N();
    if target_N <= 0.0 {
        return Err(TuningError::NoWeight(operation.kind.name()));
    }
    let least_N = 0.0 - model.rig.push_N();
    let mut search = Search::new(guess_N(model, operation, settings)?, least_N);
    let mut nearest: Option<TunedHookLoad> = None;
    for run in 1..=MAX_TUNING_RUNS {
        let settings = DynamicsSettings {
            hoist_control: Some(HoistControl::HookLoad(search.lift_N)),
            ..settings.clone()
        };
        let mut simulation =
            match Simulation::with_executor(model, operation, &settings, Arc::clone(executor)) {
                Err(SetupError::Stopped) => return Err(TuningError::Stopped),
                initial => initial?,
            };
        let half_sample_s = 0.5 * simulation.sample_interval_s();
        loop {
            let left_s = simulation.end_time_s() - simulation.time_s();
            if left_s <= half_sample_s {
                break;
            }
            if !watch(run, &simulation) {
                return Err(TuningError::Stopped);
            }
            simulation.advance(simulation.sample_interval_s()).map_err(|diverged| {
                TuningError::Diverged { hook_load_N: search.lift_N, diverged }
            })?;
        }
        let found = TunedHookLoad {
            hook_load_N: search.lift_N,
            weight_on_bit_N: simulation.mean_weight_on_bit_N(),
            runs: run,
        };
        let excess_N = found.weight_on_bit_N - target_N;
        if excess_N.abs() <= settings.lift_tolerance * target_N {
            return Ok((found, simulation));
        }
        if nearest.is_none_or(|best| excess_N.abs() < (best.weight_on_bit_N - target_N).abs()) {
            nearest = Some(found);
        }
        search.learn(excess_N);
    }
    let mut nearest = nearest.unwrap_or(TunedHookLoad {
        hook_load_N: search.lift_N,
        weight_on_bit_N: f64::NAN,
        runs: 0,
    });
    nearest.runs = MAX_TUNING_RUNS;
    Err(TuningError::NotFound { target_N, nearest })
}

/// The hook load of the soft string, N. A string that turns under the independent law is dragged
/// by as much as it slides: by something between nothing and all that friction holds, and so the
/// guess is the middle.
fn guess_N(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
) -> Result<f64, SoftError> {
    let hook_load_N = |operation: &Operation| {
        let profile = soft::solve(model, operation, &SoftSettings::default())?;
        Ok(profile.scalars.hook_load_N.max(0.0 - model.rig.push_N()))
    };
    let guess_N = hook_load_N(operation)?;
    if settings.friction_law != FrictionLaw::Independent {
        return Ok(guess_N);
    }
    let slid = Operation { kind: operation.kind.without_rotation(), ..*operation };
    Ok(0.5 * (guess_N + hook_load_N(&slid)?))
}

/// Least part of the way from one side to the other that a secant goes: it does not creep along a
/// bend.
const MIN_PART: f64 = 0.08;

/// Maximum ratio of a step to the one before, as long as one side has not been found.
const GROWTH: f64 = 2.0;

/// A lift, and the excess of the weight on bit over the target under it.
#[derive(Debug, Clone, Copy)]
struct Try {
    lift_N: f64,
    excess_N: f64,
}

impl Try {
    /// Required change of the lift, by the secant through this and the `last` one; where there is
    /// none the weight follows the lift one for one, as without friction. Infinite where the weight
    /// does not change, or grows with more lift.
    fn step_N(self, last: Option<Self>) -> f64 {
        let per_lift =
            last.map_or(1.0, |last| (last.excess_N - self.excess_N) / (self.lift_N - last.lift_N));
        if per_lift > 0.0 { self.excess_N.abs() / per_lift } else { f64::INFINITY }
    }
}

/// The search for a lift: more lift leaves less weight on the bit.
#[derive(Debug, Clone)]
struct Search {
    /// The lift to try.
    lift_N: f64,
    /// The least that the rig gives.
    least_N: f64,
    /// The last one that left too much weight, and the last one that left too little.
    heavy: Option<Try>,
    light: Option<Try>,
    last: Option<Try>,
    /// Length of the last step, infinite before the first.
    step_N: f64,
}

impl Search {
    fn new(lift_N: f64, least_N: f64) -> Self {
        Self { lift_N, least_N, heavy: None, light: None, last: None, step_N: f64::INFINITY }
    }

    /// Chooses the next lift, now that this one leaves so much too much weight, N.
    fn learn(&mut self, excess_N: f64) {
        let tried = Try { lift_N: self.lift_N, excess_N };
        let last = self.last.replace(tried);
        let is_heavy = excess_N > 0.0;
        let (same, other) = if is_heavy {
            (&mut self.heavy, &mut self.light)
        } else {
            (&mut self.light, &mut self.heavy)
        };
        *same = Some(tried);
        if last.is_some_and(|last| (last.excess_N > 0.0) == is_heavy)
            && let Some(stale) = other
        {
            stale.excess_N *= 0.5;
        }
        self.lift_N = match (self.heavy, self.light) {
            (Some(heavy), Some(light)) => {
                let part = heavy.excess_N / (heavy.excess_N - light.excess_N);
                let part = part.clamp(MIN_PART, 1.0 - MIN_PART);
                heavy.lift_N + part * (light.lift_N - heavy.lift_N)
            }
            _ => {
                self.step_N = tried.step_N(last).min(GROWTH * self.step_N);
                (tried.lift_N + self.step_N.copysign(excess_N)).max(self.least_N)
            }
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::settings::WEIGHT_TOLERANCE;

    /// Tries until a lift is within a hundredth of the target; how many it took.
    fn tries(target_N: f64, first_N: f64, weight_N: impl Fn(f64) -> f64) -> Option<usize> {
        tries_from(0.0, target_N, first_N, weight_N)
    }

    /// The same of a rig that gives this lift at least.
    fn tries_from(
        least_N: f64,
        target_N: f64,
        first_N: f64,
        weight_N: impl Fn(f64) -> f64,
    ) -> Option<usize> {
        let mut search = Search::new(first_N, least_N);
        (1..=MAX_TUNING_RUNS).find(|_| {
            let excess_N = weight_N(search.lift_N) - target_N;
            if excess_N.abs() <= WEIGHT_TOLERANCE * target_N {
                return true;
            }
            search.learn(excess_N);
            false
        })
    }

    /// A string that hangs free: the weight not lifted is on the bit.
    #[test]
    fn a_straight_line_takes_two_tries() {
        for first in [300e3, 500e3, 900e3] {
            assert_eq!(tries(60e3, first, |lift| 660e3 - lift), Some(2));
        }
    }

    /// A weight that answers the lift by half or by three times as much shows its slope in two
    /// tries.
    #[test]
    fn a_steeper_or_flatter_line_takes_three_tries() {
        for slope in [0.5, 2.0, 3.0] {
            for first in [500e3, 590e3, 640e3] {
                let weight = |lift: f64| 60e3 + slope * (600e3 - lift);
                assert_eq!(tries(60e3, first, weight), Some(3), "{slope} from {first} N");
            }
        }
    }

    /// Friction holds the string over a wide range of lifts: the weight is constant there, and
    /// grows where friction has given way.
    #[test]
    fn a_plateau_is_passed() {
        let weight = |lift: f64| {
            let missing = 640e3 - lift;
            40e3 + (missing - 300e3).max(0.0) + missing.min(0.0) * 0.8
        };
        for first in [640e3, 500e3, 200e3, 0.0] {
            let tries = tries(60e3, first, weight).expect("found");
            assert!(tries <= 12, "{tries} tries from {first} N");
        }
    }

    /// Where nothing hangs the weight on the bit is the push of the rig, if any.
    #[test]
    fn a_rig_that_pushes_goes_below_zero() {
        let weight = |lift: f64| 10e3 - lift;
        assert_eq!(tries(60e3, 5e3, weight), None);
        assert_eq!(tries_from(-80e3, 60e3, 5e3, weight), Some(2));
        assert_eq!(tries_from(-40e3, 60e3, 5e3, weight), None);
    }

    /// A bit that cannot carry the requested weight, however small the lift, and a weight that
    /// jumps over it.
    #[test]
    fn what_no_lift_gives_is_not_found() {
        assert_eq!(tries(60e3, 100e3, |lift| 50e3 - lift), None);
        let jump = |lift: f64| if lift < 300e3 { 80e3 } else { 20e3 };
        assert_eq!(tries(60e3, 100e3, jump), None);
    }
}
