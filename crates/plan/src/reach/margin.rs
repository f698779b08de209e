//! Margins to each limit with the bit at one depth.

use wholestring::{
    model::Model,
    operation::Operation,
    outcome::Solution,
    statics::{
        buckling::{Place, Shape},
        soft::{SoftError, SoftProfile, SoftSettings, solve},
    },
};

use wholestring_judge::{Check, DepthLimit, DesignFactors, Judge, LimitSettings, Unchecked};

use super::settings::{ReachError, ReachSettings};
use crate::Setup;

/// Margin to one limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// The limit.
    pub limit: DepthLimit,
    /// The load that is compared with the bound, in [`DepthLimit::unit`]; NaN for a string that is
    /// locked up.
    pub load: f64,
    /// Upper bound of the load; NaN without compression.
    pub bound: f64,
    /// The margin: one or less, zero at the limit, negative beyond, no less than [`LEAST_MARGIN`];
    /// minus infinity for a string that is locked up.
    pub margin: f64,
    /// Measured depth of the smallest margin, m; `None` for limits at the surface.
    pub at_md_m: Option<f64>,
}

/// Margins to the limits of an operation with the bit at one depth.
pub type Margins = Vec<Margin>;

/// Part of the buoyed weight by which the load at the bit is reduced, to compute the reduction of
/// the push at the top.
const LESS: f64 = 1e-3;

/// A distance larger than the rounding of a depth, m.
const JUST_M: f64 = 1e-6;

/// Part of the string's buoyed weight below which nothing hangs but what rounding leaves.
const HANGS: f64 = 1e-6;

/// Least margin of a string that is not locked up: where tension leaves a pipe no capacity, its
/// load exceeds it without bound.
pub const LEAST_MARGIN: f64 = -10.0;

/// Relative difference by rounding of two ways to the same load.
const ROUNDING: f64 = 1e-9;

/// Returns the margins to the limits of an operation with the bit at its depth. A string that is
/// locked up would need infinite loads, so that its margins are infinite.
///
/// # Errors
/// A string that does not fit, or a soft string without a solution for another reason than lock-up.
pub fn margins(
    setup: &Setup,
    operation: &Operation,
    settings: &ReachSettings,
) -> Result<Margins, ReachError> {
    Ok(judged(setup, operation, settings)?.0)
}

/// Returns the same, and the limits that could not be checked; none for a string that is locked up.
pub(super) fn judged(
    setup: &Setup,
    operation: &Operation,
    settings: &ReachSettings,
) -> Result<(Margins, Vec<Unchecked>), ReachError> {
    let (soft, factors) = (&settings.soft, &settings.factors);
    let model = setup.at(operation.bit_depth_m)?;
    let concerned = DepthLimit::ALL.into_iter().filter(|limit| limit.concerns(operation, &model));
    let has_vertical = has_vertical_hole(&model, operation.bit_depth_m);
    let is_vertical =
        |limit| matches!(limit, DepthLimit::VerticalHelix | DepthLimit::VerticalSinusoid);
    let concerned = concerned.filter(|limit| has_vertical || !is_vertical(*limit));
    let profile = match solve(&model, operation, soft) {
        Ok(profile) => profile,
        Err(SoftError::LocksUp { md_m }) => {
            let margins = concerned.map(|limit| locked_up(limit, &model, factors, md_m));
            return Ok((margins.collect(), Vec::new()));
        }
        Err(error) => return Err(error.into()),
    };
    let limits = LimitSettings { factors: *factors, ..LimitSettings::default() };
    let judge = Judge { limits, ..Judge::default() };
    let checks = judge.load_limits(&model, operation, &Solution::from(&profile));
    let at =
        At { model: &model, operation, soft, factors, profile: &profile, checks: &checks.checks };
    let margins = concerned.map(|limit| at.margin(limit)).collect::<Result<_, _>>()?;
    let stops = checks.unchecked.into_iter().filter(|unchecked| unchecked.kind.stops());
    Ok((margins, stops.collect()))
}

fn locked_up(limit: DepthLimit, model: &Model, factors: &DesignFactors, md_m: f64) -> Margin {
    let bound = match limit {
        DepthLimit::TopDrive => model
            .rig
            .top_drive_torque_N_m
            .map_or(f64::NAN, |rated_N_m| rated_N_m / factors.top_drive),
        DepthLimit::Yield => 1.0 / factors.von_mises,
        DepthLimit::HookLoadZero | DepthLimit::PushSpent | DepthLimit::PushAbsorbed => 0.0,
        DepthLimit::Breakaway
        | DepthLimit::PumpPressure
        | DepthLimit::Strength
        | DepthLimit::MakeUp
        | DepthLimit::Torsion
        | DepthLimit::Hoist
        | DepthLimit::Helix
        | DepthLimit::Sinusoid
        | DepthLimit::VerticalHelix
        | DepthLimit::VerticalSinusoid => f64::NAN,
    };
    let at_md_m = Some(md_m);
    Margin { limit, load: f64::NAN, bound, margin: f64::NEG_INFINITY, at_md_m }
}

/// A depth with its soft string.
struct At<'a> {
    model: &'a Model,
    operation: &'a Operation,
    soft: &'a SoftSettings,
    factors: &'a DesignFactors,
    profile: &'a SoftProfile,
    /// The limits of string and rig, as the judge has them.
    checks: &'a [Check],
}

impl At<'_> {
    fn margin(&self, limit: DepthLimit) -> Result<Margin, ReachError> {
        let rig = &self.model.rig;
        let scalars = &self.profile.scalars;
        let margin_of = |load: f64, bound: f64, margin: f64| Margin {
            limit,
            load,
            bound,
            margin,
            at_md_m: None,
        };
        Ok(match limit {
            DepthLimit::HookLoadZero => {
                margin_of(scalars.hook_load_N, 0.0, self.share(scalars.hook_load_N, self.hangs_N()))
            }
            DepthLimit::PushSpent => {
                let load_N = scalars.hook_load_N + rig.push_with_block_N();
                margin_of(load_N, 0.0, self.share(load_N, self.hangs_N() + rig.push_with_block_N()))
            }
            DepthLimit::PushAbsorbed => {
                let arrives = self.arrives()?;
                margin_of(arrives, 0.0, arrives.min(1.0))
            }
            DepthLimit::Helix | DepthLimit::Sinusoid => self.buckling(limit, false),
            DepthLimit::VerticalHelix | DepthLimit::VerticalSinusoid => self.buckling(limit, true),
            DepthLimit::TopDrive
            | DepthLimit::Breakaway
            | DepthLimit::Hoist
            | DepthLimit::PumpPressure
            | DepthLimit::MakeUp
            | DepthLimit::Torsion
            | DepthLimit::Yield
            | DepthLimit::Strength => self.judged(limit),
        })
    }

    /// Returns the margin of a limit that the judge checks: that of the check with the least reserve.
    /// A load of zero has no check.
    fn judged(&self, limit: DepthLimit) -> Margin {
        let of_limit = self.checks.iter().filter(|check| limit.checks().contains(&check.kind));
        let limits = of_limit.filter(|check| check.factor.is_some());
        let worst = limits.min_by(|a, b| a.reserve().total_cmp(&b.reserve()));
        let Some(Check { value: Some(load), limit: Some(capacity), required, md_m, .. }) = worst
        else {
            let (load, bound) = self.not_loaded(limit);
            return Margin { limit, load, bound, margin: 1.0, at_md_m: None };
        };
        let required = required.unwrap_or(1.0);
        let margin = match *capacity > 0.0 {
            true => (1.0 - load * required / capacity).max(LEAST_MARGIN),
            false => LEAST_MARGIN,
        };
        // As a part of its capacity, where the limit stands for several quantities.
        let (load, capacity) =
            if limit.unit().is_empty() { (load / capacity, 1.0) } else { (*load, *capacity) };
        Margin { limit, load, bound: capacity / required, margin, at_md_m: *md_m }
    }

    /// Returns load and bound of a limit without a load: a string that the block pushes loads the
    /// hoist with less than nothing.
    fn not_loaded(&self, limit: DepthLimit) -> (f64, f64) {
        let rig = &self.model.rig;
        match (limit, rig.hoist_capacity_N) {
            (DepthLimit::Hoist, Some(capacity_N)) => {
                let block_N = rig.block_weight_N.unwrap_or(0.0);
                let load_N = self.profile.scalars.hook_load_N + block_N;
                (load_N, capacity_N / self.factors.hoist)
            }
            _ => (0.0, f64::NAN),
        }
    }

    /// Returns the hook load without friction and off bottom, N: the weight of the string along the
    /// hole, and the pull of the mud.
    fn hangs_N(&self) -> f64 {
        let scalars = &self.profile.scalars;
        scalars.hook_load_N - scalars.axial_friction_N - self.operation.tension_at_bit_N()
    }

    /// Returns a load as a part of the hanging weight; where that is not positive but for rounding,
    /// as of a string that lies level, its sign.
    fn share(&self, load_N: f64, hangs_N: f64) -> f64 {
        match hangs_N > HANGS * self.model.buoyed_weight_N() {
            true => (load_N / hangs_N).max(LEAST_MARGIN),
            false => load_N.signum(),
        }
    }

    /// Returns the margin where compression over the critical load is largest, among the places
    /// where the wall holds the pipe straight or among those where only its weight does.
    fn buckling(&self, limit: DepthLimit, vertical: bool) -> Margin {
        let is_helix = matches!(limit, DepthLimit::Helix | DepthLimit::VerticalHelix);
        let shape = usize::from(is_helix);
        let rows = 0..self.profile.md_m.len();
        let along = rows.filter_map(|row| {
            let profile = &self.profile;
            Some((row, [profile.sinusoidal_load_N[row]?, profile.helical_load_N[row]?]))
        });
        let below = self.below_jumps();
        let mut worst = Margin { limit, load: 0.0, bound: f64::NAN, margin: 1.0, at_md_m: None };
        for (row, loads_N) in along.chain(below) {
            let (load, critical_N) = (-self.profile.tension_N[row], loads_N[shape]);
            let margin = 1.0 - load / critical_N;
            if margin < worst.margin && self.is_vertical(row, loads_N[1]) == vertical {
                let at_md_m = Some(self.profile.md_m[row]);
                worst = Margin { limit, load, bound: critical_N, margin, at_md_m };
            }
        }
        worst
    }

    /// Returns the rows where curvature, hole or component may jump, with the critical loads just
    /// below, because the profile has those of the stretch above.
    fn below_jumps(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        let bit_depth_m = self.operation.bit_depth_m;
        let well = &self.model.well;
        let stations = well.path.stations().iter().map(|station| station.md_m);
        let sections = well.hole.sections().iter().map(|section| section.to_md_m);
        let components = self.model.string.spans().map(move |span| bit_depth_m - span.to_bit_m);
        let jumps = stations.chain(sections).chain(components);
        let inside = jumps.filter(move |md_m| *md_m > 0.0 && *md_m < bit_depth_m - JUST_M);
        inside.filter_map(move |md_m| {
            let row = self.profile.md_m.partition_point(|row_m| *row_m < md_m - JUST_M);
            let compression_N = -*self.profile.tension_N.get(row)?;
            if compression_N <= 0.0 {
                return None;
            }
            let place = Place::of(self.model, bit_depth_m, md_m + JUST_M);
            Some((row, place.loads_N(self.model.buckling, compression_N)?))
        })
    }

    /// Whether the load of the helix is that of a vertical hole, which results from the weight
    /// alone: it is the largest there, and the hole is so steep that the weight across it does not
    /// hold the pipe better. In a level hole whose curvature lifts the pipe off the wall the same
    /// load is the governing minimum, but the hole is not vertical. Sinusoid and helix are divided
    /// by this one load, so that the helix of no place begins before its sinusoid.
    fn is_vertical(&self, row: usize, critical_N: f64) -> bool {
        let md_m = self.profile.md_m[row];
        let place = Place::above(self.model, self.operation.bit_depth_m, md_m);
        let shape = self.model.buckling.helix();
        critical_N <= place.vertical_load_N(shape) * (1.0 + ROUNDING) && is_steep(&place, shape)
    }

    /// Returns the part of an added push at the top that reaches the bit; more than one where it
    /// reduces tension, and thus friction, in a bend. It is found from a slightly smaller load at
    /// the bit, with which the string does not lock up either.
    fn arrives(&self) -> Result<f64, ReachError> {
        let less_N = LESS * self.model.buoyed_weight_N();
        let pushed = match self.operation.kind.on_bottom() {
            true => self.operation.weight_on_bit_N(self.operation.weight_on_bit_N - less_N),
            false => self.operation.bit_pull_N(self.operation.bit_pull_N + less_N),
        };
        let less = solve(self.model, &pushed, self.soft)?;
        Ok(less_N / (less.scalars.hook_load_N - self.profile.scalars.hook_load_N))
    }
}

/// Whether the weight across the hole does not hold a pipe better than a vertical hole does.
fn is_steep(place: &Place, shape: Shape) -> bool {
    let held_N = place.vertical_load_N(shape) * (1.0 + ROUNDING);
    place.threshold_N(shape, place.weight_across_N_per_m) <= held_N
}

/// Whether a well has a vertical stretch above the bit: without one no string can be a helix in it.
fn has_vertical_hole(model: &Model, bit_depth_m: f64) -> bool {
    let shape = model.buckling.helix();
    let stations = model.well.path.stations().iter().map(|station| station.md_m);
    let mut depths = stations.filter(|md_m| *md_m <= bit_depth_m).chain([JUST_M, bit_depth_m]);
    depths.any(|md_m| is_steep(&Place::above(model, bit_depth_m, md_m), shape))
}
