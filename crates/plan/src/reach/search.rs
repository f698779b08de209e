//! Margins against depth, and the first zero of each.

use wholestring::operation::{Operation, OperationKind};
use wholestring_judge::DepthLimit;

use super::{
    margin::{Margin, margins},
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
}

impl End {
    /// Returns the depth where the limit is reached, m.
    pub const fn depth_m(self) -> Option<f64> {
        match self {
            Self::At(depth_m) | Self::Already(depth_m) => Some(depth_m),
            Self::NoneTo(_) => None,
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
    /// The margin there, nearly zero. For a limit that is not reached: at the last depth.
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
        false => margins(setup, &Operation { bit_depth_m, ..*operation }, settings),
    };
    let depth_m = settings.grid_m();
    let rows: Vec<_> = depth_m.iter().map(|depth_m| at(*depth_m)).collect::<Result<_, _>>()?;
    let curves = (0..rows[0].len()).map(|index| {
        let margins: Vec<Margin> = rows.iter().map(|row| row[index]).collect();
        let one = |depth_m: f64| at(depth_m).map(|row| row[index]);
        let (end, there) = end(&depth_m, &margins, one, settings.tolerance_m)?;
        let limit = margins[0].limit;
        // With a block or a rig that pushes, the string continues at a hook load of zero.
        let pushes = limit == DepthLimit::HookLoadZero && setup.rig.push_with_block_N() > 0.0;
        let stops =
            limit.stops() && !pushes || settings.stop_at_helix && limit == DepthLimit::Helix;
        Ok(Curve { limit, stops, margins, end, there })
    });
    let curves = curves.collect::<Result<_, ReachError>>()?;
    Ok(OperationReach { kind: operation.kind, depth_m, curves })
}

fn end(
    depth_m: &[f64],
    margins: &[Margin],
    one: impl Fn(f64) -> Result<Margin, ReachError>,
    tolerance_m: f64,
) -> Result<(End, Margin), ReachError> {
    let met = margins.iter().position(|margin| margin.margin <= 0.0);
    let Some(met) = met else {
        let last = margins.len() - 1;
        return Ok((End::NoneTo(depth_m[last]), margins[last]));
    };
    let Some(above) = met.checked_sub(1) else {
        return Ok((End::Already(depth_m[0]), margins[0]));
    };
    let end = |index: usize| (depth_m[index], bounded(margins[index].margin));
    let margin_at = |depth_m: f64| one(depth_m).map(|margin| bounded(margin.margin));
    let found_m = root(margin_at, [end(above), end(met)], tolerance_m)?;
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
    let all = reaches.iter().flat_map(|reach| reach.curves.iter().map(move |curve| (reach, curve)));
    let met = all.filter(|(_, curve)| curve.stops);
    let met = met.filter_map(|pair| Some((pair.1.end.depth_m()?, pair)));
    let first = met.min_by(|(a_m, (_, a)), (b_m, (_, b))| {
        let exceeded = a.there.margin.total_cmp(&b.there.margin);
        a_m.total_cmp(b_m).then(exceeded)
    });
    first.map(|(_, pair)| pair)
}
