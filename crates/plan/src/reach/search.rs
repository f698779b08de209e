//! Margins against depth, and the first zero of each.

use wholestring::operation::{Operation, OperationKind};
use wholestring_judge::{DepthLimit, Unchecked};

use super::{
    margin::{Margin, Margins, judged},
    settings::{ReachError, ReachSettings},
};
use crate::{Setup, root};

/// Result of a limit on the way down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// It is reached with the bit at this depth, m.
    At(f64),
    /// It is reached or exceeded at the first depth of the grid, m.
    Already(f64),
    /// It is not reached down to this depth, m.
    NoneTo(f64),
    /// The string locks up at this depth, m, and has not reached the limit before; it is the first
    /// depth of the grid where nothing is known of the limit.
    LockedUp(f64),
}

impl End {
    /// Returns the depth where the limit is reached, m.
    pub const fn depth_m(self) -> Option<f64> {
        match self {
            Self::At(depth_m) | Self::Already(depth_m) => Some(depth_m),
            Self::NoneTo(_) | Self::LockedUp(_) => None,
        }
    }

    /// Returns the depth where the string locks up before it reaches the limit, m.
    pub const fn locked_up_m(self) -> Option<f64> {
        match self {
            Self::LockedUp(depth_m) => Some(depth_m),
            Self::At(_) | Self::Already(_) | Self::NoneTo(_) => None,
        }
    }
}

/// One limit against the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The limit.
    pub limit: DepthLimit,
    /// Whether the string stops there.
    pub stops: bool,
    /// Its margins, at each depth of the grid.
    pub margins: Vec<Margin>,
    /// Depth at which it is first reached, if it is.
    pub end: End,
    /// The margin there, nearly zero. For a limit that is not reached: at the last depth that has
    /// one.
    pub there: Margin,
}

/// The limits of one operation against the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct OperationReach {
    /// The operation.
    pub kind: OperationKind,
    /// Depths of the bit, m.
    pub depth_m: Vec<f64>,
    /// Its limits.
    pub curves: Vec<Curve>,
    /// Limits that stop it and could not be checked.
    pub unchecked: Vec<Unchecked>,
}

impl OperationReach {
    /// Returns the limit that stops it, with its depth, m; of limits that are reached at the same
    /// depth, the one that is exceeded most.
    pub fn stop(&self) -> Option<(f64, &Curve)> {
        let stops = self.curves.iter().filter(|curve| curve.stops);
        let met = stops.filter_map(|curve| Some((curve.end.depth_m()?, curve)));
        met.min_by(|(a_m, a), (b_m, b)| {
            a_m.total_cmp(b_m).then(a.there.margin.total_cmp(&b.there.margin))
        })
    }
}

/// Returns the reach of an operation: its limits against depth. The operation's own depth is not
/// used.
///
/// # Errors
/// Depths that do not increase, a string that is longer than the first of them, or a soft string
/// without a solution for another reason than lock-up.
pub fn reach(
    setup: &Setup,
    operation: &Operation,
    settings: &ReachSettings,
) -> Result<OperationReach, ReachError> {
    reach_unless(setup, operation, settings, &|| false)
}

/// Like [`reach`], with a function that is called at every depth and can stop it.
///
/// # Errors
/// Those of [`reach`], and [`ReachError::Stopped`].
pub fn reach_unless(
    setup: &Setup,
    operation: &Operation,
    settings: &ReachSettings,
    is_stopped: &dyn Fn() -> bool,
) -> Result<OperationReach, ReachError> {
    let ReachSettings { from_m, to_m, .. } = *settings;
    if to_m.partial_cmp(&from_m) != Some(std::cmp::Ordering::Greater) {
        return Err(ReachError::Depths { from_m, to_m });
    }
    let at = |bit_depth_m: f64| match is_stopped() {
        true => Err(ReachError::Stopped),
        false => judged(setup, &Operation { bit_depth_m, ..*operation }, settings),
    };
    let depth_m = settings.grid_m();
    let all_m = with_passages_m(setup, &depth_m);
    let mut rows: Vec<(f64, Margins)> = Vec::with_capacity(all_m.len());
    let mut unchecked = Vec::new();
    for depth_m in all_m {
        let (margins, lacking) = at(depth_m)?;
        if unchecked.is_empty() {
            unchecked = lacking;
        }
        rows.push((depth_m, margins));
    }
    let limits: Vec<DepthLimit> = rows[0].1.iter().map(|margin| margin.limit).collect();
    // The limit that a string meets which is locked up at the first depth already.
    let lock = match limits.contains(&DepthLimit::PushAbsorbed) {
        true => Some(DepthLimit::PushAbsorbed),
        false => limits.iter().copied().find(|limit| limit.stops()),
    };
    let curves = limits.iter().enumerate().map(|(index, &limit)| {
        let points: Vec<(f64, Margin)> =
            rows.iter().map(|(depth_m, margins)| (*depth_m, margins[index])).collect();
        let one = |depth_m: f64| at(depth_m).map(|(margins, _)| margins[index]);
        let (end, there) = end(&points, one, Some(limit) == lock, settings.tolerance_m)?;
        // With a block or a rig that pushes, the string continues at a hook load of zero.
        let pushes = limit == DepthLimit::HookLoadZero && setup.rig.push_with_block_N() > 0.0;
        let stops =
            limit.stops() && !pushes || settings.stop_at_helix && limit == DepthLimit::Helix;
        let of_grid = points.iter().filter(|(at_m, _)| depth_m.contains(at_m));
        let margins = of_grid.map(|(_, margin)| *margin).collect();
        Ok(Curve { limit, stops, margins, end, there })
    });
    let curves = curves.collect::<Result<_, ReachError>>()?;
    Ok(OperationReach { kind: operation.kind, depth_m, curves, unchecked })
}

/// Returns the depths of the grid and, between them, those at which a component enters or leaves a
/// curved stretch, m, increasing.
fn with_passages_m(setup: &Setup, grid_m: &[f64]) -> Vec<f64> {
    let ends_m = [grid_m[0], grid_m[grid_m.len() - 1]];
    let mut all_m: Vec<f64> = grid_m.iter().copied().chain(passages_m(setup, ends_m)).collect();
    all_m.sort_by(f64::total_cmp);
    all_m.dedup();
    all_m
}

fn end(
    points: &[(f64, Margin)],
    one: impl Fn(f64) -> Result<Margin, ReachError>,
    is_lock: bool,
    tolerance_m: f64,
) -> Result<(End, Margin), ReachError> {
    let met = points.iter().position(|(_, margin)| margin.margin <= 0.0);
    let Some(met) = met else {
        let (last_m, last) = points[points.len() - 1];
        return Ok((End::NoneTo(last_m), last));
    };
    let Some(above) = met.checked_sub(1) else {
        let (first_m, first) = points[0];
        let is_locked_up = first.margin == f64::NEG_INFINITY;
        let end = match is_locked_up && !is_lock {
            true => End::LockedUp(first_m),
            false => End::Already(first_m),
        };
        return Ok((end, first));
    };
    let end = |index: usize| (points[index].0, bounded(points[index].1.margin));
    let margin_at = |depth_m: f64| one(depth_m).map(|margin| bounded(margin.margin));
    let found_m = root(margin_at, [end(above), end(met)], tolerance_m)?;
    // The margin of a string that locks up falls without end: that is no zero of this limit.
    let locks_up = one(found_m + tolerance_m)?.margin == f64::NEG_INFINITY;
    if locks_up && !is_lock {
        return Ok((End::LockedUp(found_m), one((found_m - tolerance_m).max(points[above].0))?));
    }
    Ok((End::At(found_m), one(found_m)?))
}

/// Limits a margin to -1 to 1 without changing its zero, because that of a string that locks up is
/// infinite.
fn bounded(margin: f64) -> f64 {
    match margin.is_finite() {
        true => margin / (1.0 + margin.abs()),
        false => margin.signum(),
    }
}

/// Returns the first limit that stops a string, of any operation: the operation and its curve. Of
/// those that are reached already at the first depth, the one that is exceeded most.
pub fn first_stop(reaches: &[OperationReach]) -> Option<(&OperationReach, &Curve)> {
    let met = reaches.iter().filter_map(|reach| Some((reach, reach.stop()?)));
    let first = met.min_by(|(_, (a_m, a)), (_, (b_m, b))| {
        a_m.total_cmp(b_m).then(a.there.margin.total_cmp(&b.there.margin))
    });
    first.map(|(reach, (_, curve))| (reach, curve))
}

// Depths of the bit at which components pass curved stretches of the hole.

/// Distance from an end of a component to a station that it is about to pass, m.
const BEFORE_M: f64 = 0.5;

/// Distance of an end that has passed a station, m: more than a step of the soft string.
const BEYOND_M: f64 = 5.5;

/// Least distance of two depths, m.
const LEAST_M: f64 = 10.0;

/// Most depths.
const MOST: f64 = 40.0;

/// Returns the depths of the bit, m, between two ends, at which an end of a component below the
/// topmost is just above or just below a station of the survey or the end of a hole section. There
/// the largest stress of a stiff component in a dogleg begins and ends, which may be missed by a
/// grid of depths. Depths close together are thinned.
fn passages_m(setup: &Setup, [from_m, to_m]: [f64; 2]) -> Vec<f64> {
    let below_m = setup.below_topmost_m();
    let stations = setup.well.path.stations().iter().map(|station| station.md_m);
    let sections = setup.well.hole.sections().iter().map(|section| section.to_md_m);
    let places_m: Vec<f64> =
        stations.chain(sections).filter(|md_m| md_m + below_m + BEYOND_M > from_m).collect();
    let ends_m = setup.component_ends_m();
    let passed = ends_m.iter().flat_map(|end_m| {
        let pairs = places_m.iter().map(move |place_m| place_m + end_m);
        pairs.flat_map(|at_m| [at_m - BEFORE_M, at_m + BEYOND_M])
    });
    let mut depths_m: Vec<f64> = passed.filter(|at_m| *at_m > from_m && *at_m < to_m).collect();
    depths_m.sort_by(f64::total_cmp);
    let [Some(first_m), Some(last_m)] = [depths_m.first(), depths_m.last()] else {
        return depths_m;
    };
    let apart_m = ((last_m - first_m) / MOST).max(LEAST_M);
    let mut kept_m: Vec<f64> = Vec::new();
    for at_m in depths_m {
        if kept_m.last().is_none_or(|kept_m| at_m - kept_m >= apart_m) {
            kept_m.push(at_m);
        }
    }
    kept_m
}
