//! Whether a string goes down: by its weight, with the block and the rig pushing, or not at all.
//!
//! One rule serves every model and every command. The hook load of the solver, with its pull of the
//! mud, decides how much the string needs at the top; the block (where its weight is known) and a
//! rig that pushes decide how much the top can give. Where the solver does not count the friction
//! of a helix, this rule does.

use std::convert::Infallible;

use wholestring::{
    model::Model,
    operation::Operation,
    outcome::{
        Column, Profile, TIME_SERIES, TimeSeries,
        samples::{ends, mean},
    },
    statics::buckling::{Criterion, Pushed, Segment, push_through, segments, weight_at_bit_N},
};

use crate::{Check, CheckKind, LimitSettings, Severity, Verdict, root::root, window::Window};

/// Part of the string's buoyed weight below which a load counts as zero, because no indicator shows
/// it.
const NONE: f64 = 1e-3;

/// Part of the string's buoyed weight that the weight at the bit may miss by the rounding of its
/// stretches.
const ROUNDING: f64 = 1e-6;

/// A string that goes down by less than this part of the block's travel does not follow it.
const FOLLOWS: f64 = 0.1;

/// Part of the requested weight below which it counts as not reached in a dynamic run.
const ARRIVES: f64 = 0.8;

/// Accuracy to which a stretch reproduces the solver's tension, N: a thousand stretches miss a hook
/// load by 1 mN.
const EXACT_N: f64 = 1e-6;

/// First trial of the force along a stretch that locks up without it, N.
const LARGE_N: f64 = 1e5;

/// Doublings of that force until it is too large.
const MAX_DOUBLINGS: usize = 30;

/// Forces that drive a string down, forces that hold it back, and the weight that reaches the bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Descent {
    /// Hook load without the block, N.
    pub hook_load_N: f64,
    /// Weight of the block, N; `None` where it is not known.
    pub block_N: Option<f64>,
    /// Largest push of a rig that pushes, N; `None` for a rig that only carries.
    pub injector_N: Option<f64>,
    /// Axial friction, N.
    pub drag_N: f64,
    /// Requested weight on bit, N.
    pub requested_N: f64,
    /// Weight that reaches the bit with the whole string slacked off, block and rig pushing, N;
    /// negative by the force that is missing to move the string.
    pub arrives_N: f64,
    /// Measured depth above which the helix absorbs any push, m.
    pub absorbed_above_md_m: Option<f64>,
    /// Whether the string locks up before it reaches its depth.
    pub locks_up: bool,
    /// Whether its own weight drives it down, or a rig whose purpose is to push.
    pub by_its_weight: bool,
    /// Whether its own weight does so alone, without that rig.
    pub is_unaided: bool,
    /// Whether the result is that of a dynamic run.
    pub in_time: bool,
}

impl Descent {
    /// Descent in a static equilibrium with this hook load and axial friction, N. `None` for a
    /// string that does not slide down.
    pub fn at_rest(
        model: &Model,
        operation: &Operation,
        [hook_load_N, axial_friction_N]: [f64; 2],
        profile: &Profile,
        has_helix_friction: bool,
    ) -> Option<Self> {
        if !operation.slides_down() {
            return None;
        }
        let segments = calibrated(model, operation, profile, has_helix_friction);
        let requested_N = operation.weight_on_bit_now_N();
        let arrives_N = weight_at_bit_N(&segments, model.rig.push_with_block_N(), model.buckling);
        let absorbed_above_md_m = match push_through(&segments, requested_N, model.buckling) {
            Pushed::LocksUp(above_bit_m) => Some(operation.bit_depth_m - above_bit_m),
            Pushed::Through(_) => None,
        };
        let buoyed_N = model.buoyed_weight_N();
        let (none_N, rounding_N) = (NONE * buoyed_N, ROUNDING * buoyed_N);
        let locks_up = arrives_N < requested_N - rounding_N;
        // The hook load is that of the solver, which may leave out the drag of the helix.
        let arrives_by = |at_top_N: f64| {
            weight_at_bit_N(&segments, at_top_N, model.buckling) >= requested_N - rounding_N
        };
        let is_unaided = hook_load_N > none_N && !locks_up && arrives_by(0.0);
        let by_its_weight = hook_load_N > least_hook_load_N(model) && !locks_up;
        Some(Self {
            arrives_N,
            absorbed_above_md_m: absorbed_above_md_m.filter(|_| locks_up),
            locks_up,
            by_its_weight: is_unaided || by_its_weight && arrives_by(model.rig.push_N()),
            is_unaided,
            ..Self::loads(model, operation, [hook_load_N, axial_friction_N])
        })
    }

    /// Descent in a dynamic run, whose wall forces are those of the string as it lies: the hook is
    /// slack, or the rig pushes with its full force, and the string stops or does not press on the
    /// bit.
    pub fn in_time(model: &Model, operation: &Operation, window: &Window<'_>) -> Option<Self> {
        if !operation.slides_down() {
            return None;
        }
        let mean = |name: &str| Some(window.statistic(name)?.mean);
        let hook_load_N = mean("hook_load_N")?;
        let arrives_N = mean("weight_on_bit_N")?;
        let drag_N = mean("axial_friction_N").unwrap_or(0.0);
        let loads = Self::loads(model, operation, [hook_load_N, drag_N]);
        let slack_N = NONE * model.buoyed_weight_N() - model.rig.push_N();
        let slack = hook_load_N <= slack_N;
        let short = match loads.requested_N > 0.0 {
            true => arrives_N < ARRIVES * loads.requested_N,
            false => !follows(window),
        };
        let locks_up = slack && short;
        Some(Self {
            arrives_N,
            locks_up,
            by_its_weight: hook_load_N > least_hook_load_N(model) && !locks_up,
            is_unaided: hook_load_N > NONE * model.buoyed_weight_N() && !locks_up,
            in_time: true,
            ..loads
        })
    }

    fn loads(
        model: &Model,
        operation: &Operation,
        [hook_load_N, axial_friction_N]: [f64; 2],
    ) -> Self {
        Self {
            hook_load_N,
            block_N: model.rig.block_weight_N,
            injector_N: model.rig.snubbing_force_N,
            drag_N: axial_friction_N.abs(),
            requested_N: operation.weight_on_bit_now_N(),
            arrives_N: f64::NAN,
            absorbed_above_md_m: None,
            locks_up: false,
            by_its_weight: true,
            is_unaided: true,
            in_time: false,
        }
    }

    /// The lock-up limit: friction and requested weight compared with friction and the weight that
    /// reaches the bit.
    pub(crate) fn lock_up(
        &self,
        model: &Model,
        operation: &Operation,
        settings: &LimitSettings,
    ) -> Option<Check> {
        let (load_N, capacity_N) =
            (self.drag_N + self.requested_N, (self.drag_N + self.arrives_N).max(0.0));
        let required = settings.factors.lock_up;
        let check = Check::load(CheckKind::LockUp, load_N, capacity_N, required)?;
        let check = match self.locks_up {
            true => Check { verdict: Verdict::Exceeded, severity: Severity::Error, ..check },
            // Beyond the limit by rounding alone, for a string that reaches its depth.
            false if matches!(check.verdict, Verdict::Exceeded | Verdict::Marginal) => {
                // Only the block drives a string that its weight does not, and hardly so.
                let severity = if self.by_its_weight { Severity::Note } else { Severity::Warning };
                Check { verdict: Verdict::Marginal, severity, ..check }
            }
            false => check,
        };
        Some(match self.absorbed_above_md_m {
            Some(md_m) => {
                let component = model.string.component_at(operation.bit_depth_m - md_m).1;
                check.of_component(&component.name).at(md_m)
            }
            None => check,
        })
    }
}

/// A requested weight on bit that the string does not have even without friction; with the bit so
/// shallow no statement on friction is possible.
pub(crate) fn weight_not_available(
    model: &Model,
    operation: &Operation,
    [hook_load_N, axial_friction_N]: [f64; 2],
) -> Option<Check> {
    let requested_N = operation.weight_on_bit_now_N();
    let left_N = hook_load_N - axial_friction_N + model.rig.push_with_block_N();
    let check = || {
        let available_N = (requested_N + left_N).max(0.0);
        let check = Check::reported(CheckKind::WeightNotAvailable, Severity::Error);
        check.value(requested_N).limit(available_N)
    };
    (requested_N > 0.0 && left_N < -NONE * model.buoyed_weight_N()).then(check)
}

/// Whether a string goes down by its weight: for every operation that goes down, and for any other
/// one in which the hook load is not positive. A string that slides down is judged by the balance of
/// forces of its lock-up, block and rig not counted. A block that pushes makes it a warning.
pub(crate) fn goes_down(
    model: &Model,
    operation: &Operation,
    hook_load_N: f64,
    descent: Option<&Descent>,
) -> Option<Check> {
    let least_N = least_hook_load_N(model);
    let hangs = hook_load_N > least_N;
    let severity = match descent {
        Some(descent) if descent.locks_up => Severity::Error,
        // A static descent that does not lock up reaches its depth, pushed.
        Some(descent) if !descent.in_time => match descent.by_its_weight {
            true => Severity::Ok,
            false => Severity::Warning,
        },
        _ if hangs => Severity::Ok,
        _ if hook_load_N + model.rig.block_weight_N.unwrap_or(0.0) > least_N => Severity::Warning,
        _ => Severity::Error,
    };
    let goes_down = descent.is_some() || operation.axial_velocity_m_per_s() > 0.0;
    let limit_N = 0.0 - model.rig.push_N();
    let check = || Check::reported(CheckKind::GoesDown, severity).value(hook_load_N).limit(limit_N);
    // A level string that does not move hangs with nothing but what rounding leaves.
    let is_pushed = match model.rig.snubbing_force_N {
        Some(_) => !hangs,
        None => hook_load_N < -least_N,
    };
    (goes_down || is_pushed).then(check)
}

/// The same for a dynamic run that goes slack only at times.
pub(crate) fn goes_slack(model: &Model, window: &Window<'_>) -> Option<Check> {
    let least_N = window.statistic("hook_load_N")?.min;
    let limit_N = 0.0 - model.rig.push_N();
    let check =
        || Check::reported(CheckKind::GoesDown, Severity::Warning).value(least_N).limit(limit_N);
    (least_N <= least_hook_load_N(model)).then(check)
}

/// The smallest hook load of a string that goes down. A rig that pushes does so up to its force.
fn least_hook_load_N(model: &Model) -> f64 {
    match model.rig.snubbing_force_N {
        Some(push_N) => -push_N * (1.0 - NONE),
        None => NONE * model.buoyed_weight_N(),
    }
}

const BIT_DEPTH: &Column<TimeSeries> = Column::named(TIME_SERIES, "bit_depth_m");
const BLOCK_VELOCITY: &Column<TimeSeries> = Column::named(TIME_SERIES, "block_velocity_m_per_s");

/// Whether the bit follows the block.
fn follows(window: &Window<'_>) -> bool {
    let went_m = ends(&window.scalar(BIT_DEPTH)).map_or(0.0, |[first_m, last_m]| last_m - first_m);
    let block_m_per_s = mean(&window.scalar(BLOCK_VELOCITY));
    let block_travel_m = block_m_per_s * window.length_s();
    block_travel_m <= 0.0 || went_m >= FOLLOWS * block_travel_m
}

/// Divides the string into stretches that reproduce the solver's own tension. Effects that the
/// solver counts and a stretch does not (the pull of the mud, friction of a wall load by another
/// rule) become a force along the stretch. The string therefore goes down by this rule where it
/// does by the hook load; the friction of a helix that the solver does not count is added.
fn calibrated(
    model: &Model,
    operation: &Operation,
    profile: &Profile,
    has_helix_friction: bool,
) -> Vec<Segment> {
    let mut stretches = segments(model, operation, &profile.md_m);
    let mut to_md_m = operation.bit_depth_m;
    for stretch in &mut stretches {
        let from_md_m = to_md_m - stretch.length_m;
        let [upper_N, lower_N] = [from_md_m, to_md_m].map(|md_m| -tension_N(profile, md_m));
        correct(stretch, [lower_N, upper_N], model.buckling, has_helix_friction);
        to_md_m = from_md_m;
    }
    stretches
}

/// Adds to a stretch the axial force, N, with which its compression at the lower end becomes that
/// at the upper end; includes the wall load of a helix where the solver counts that.
fn correct(
    stretch: &mut Segment,
    [lower_N, upper_N]: [f64; 2],
    criterion: Criterion,
    has_helix_friction: bool,
) {
    let length_m = stretch.length_m;
    let plain = *stretch;
    // Excess of the compression at the upper end. It falls with the force, but not evenly where the
    // helix begins within the stretch.
    let excess_N = |force_N: f64| {
        let weight_along_N_per_m = plain.weight_along_N_per_m + force_N / length_m;
        let stretch = Segment { weight_along_N_per_m, ..plain };
        let pushed_N = match has_helix_friction {
            false => stretch.push_straight_N(lower_N),
            true => match push_through(&[stretch], lower_N, criterion) {
                Pushed::Through(pushed_N) => pushed_N,
                Pushed::LocksUp(_) => f64::INFINITY,
            },
        };
        pushed_N - upper_N
    };
    stretch.weight_along_N_per_m += zero(excess_N) / length_m;
}

/// The force, N, at which a function that falls by about as much as the force grows is zero.
fn zero(function_N: impl Fn(f64) -> f64) -> f64 {
    let at_none = (0.0, function_N(0.0));
    if at_none.1.abs() <= EXACT_N {
        return 0.0;
    }
    let mut far_N = at_none.1.clamp(-LARGE_N, LARGE_N);
    let mut far = (far_N, function_N(far_N));
    for _ in 0..MAX_DOUBLINGS {
        if far.1.abs() <= EXACT_N || far.1 * at_none.1 < 0.0 {
            break;
        }
        far_N *= 2.0;
        far = (far_N, function_N(far_N));
    }
    if far.1.abs() <= EXACT_N {
        return far.0;
    }
    let is_bracketed = far.1 * at_none.1 < 0.0;
    if !is_bracketed {
        // A tension that is not a number.
        return 0.0;
    }
    let Ok(force_N) =
        root(|force_N| Ok::<_, Infallible>(function_N(force_N)), [at_none, far], EXACT_N);
    force_N
}

/// Tension at a measured depth, N, linear between rows.
fn tension_N(profile: &Profile, md_m: f64) -> f64 {
    let (depths, tensions) = (&profile.md_m, &profile.tension_N);
    let below = depths.partition_point(|depth| *depth < md_m);
    match (below.checked_sub(1), tensions.get(below)) {
        (None, Some(first)) => *first,
        (Some(above), None) => tensions[above],
        (Some(above), Some(lower)) => {
            let part = (md_m - depths[above]) / (depths[below] - depths[above]);
            tensions[above] + part * (lower - tensions[above])
        }
        (None, None) => 0.0,
    }
}
