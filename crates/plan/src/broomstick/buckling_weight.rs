//! The weight on bit under which a string begins to buckle.

use wholestring::{
    operation::{Operation, OperationKind},
    statics::soft::{SoftError, SoftString},
};

use wholestring_judge::NoAnswer;

use super::Broomstick;
use crate::FrictionLevel;
use crate::root;

/// Upper limit of the weight on bit, N: a string that does not buckle below it does not buckle in
/// practice.
const MOST_N: f64 = 5e6;

/// Tolerance of the weight, as a part of it, and the least tolerance, N.
const PART: f64 = 1e-4;
const LEAST_N: f64 = 1.0;

/// Default rotary speed of a string whose operations do not turn, rad/s: 60 rev/min.
pub(crate) const USUAL_ROTATION_RAD_PER_S: f64 = 2.0 * std::f64::consts::PI;

/// Default rate of penetration, m/s: 10 m/h. The soft string uses only its sign, and for a rotating
/// string requires a small value.
const USUAL_RATE_M_PER_S: f64 = 10.0 / 3600.0;

/// The least weight on bit under which a string buckles somewhere, at one depth with one friction.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingWeight {
    /// Friction level.
    pub friction: FrictionLevel,
    /// Kind of drilling: [`OperationKind::Drill`], rotating, or [`OperationKind::Slide`].
    pub operation: OperationKind,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Weights for a sinusoid and for a helix, N: zero where it buckles without weight, `None`
    /// where it does not buckle below the upper limit. Or the reason why they are not known.
    pub weights_N: Result<[Option<f64>; 2], NoAnswer>,
}

impl Broomstick {
    /// Returns the weights on bit under which the soft string begins to buckle with its bit at a
    /// depth, m, for each of [`FrictionLevel::ALL`] and each kind of drilling.
    pub fn weights_to_buckle(&self, bit_depth_m: f64) -> Vec<BucklingWeight> {
        at(self, bit_depth_m, &FrictionLevel::ALL)
    }

    /// Like [`weights_to_buckle`](Self::weights_to_buckle) with the expected friction only.
    pub fn expected_weights_to_buckle(&self, bit_depth_m: f64) -> Vec<BucklingWeight> {
        at(self, bit_depth_m, &[FrictionLevel::Expected])
    }
}

/// Returns the weights for each of these frictions and each kind of drilling.
fn at(broomstick: &Broomstick, bit_depth_m: f64, levels: &[FrictionLevel]) -> Vec<BucklingWeight> {
    let base = broomstick.operations.first().copied();
    let base = base.unwrap_or_else(|| Operation::drill(bit_depth_m));
    let mut found = Vec::new();
    for friction in levels.iter().copied() {
        let model = broomstick.setup(friction).at(bit_depth_m).map_err(NoAnswer::from);
        let string = match &model {
            Ok(model) => {
                SoftString::new(model, bit_depth_m, &broomstick.soft).map_err(NoAnswer::from)
            }
            Err(why) => Err(why.clone()),
        };
        for operation in [OperationKind::Drill, OperationKind::Slide] {
            let own = broomstick.operations.iter().find(|own| own.kind == operation);
            let operation = drilling(*own.unwrap_or(&base), operation, bit_depth_m);
            let weights_N = match &string {
                Ok(string) => weights_N(string, &operation),
                Err(why) => Err(why.clone()),
            };
            found.push(BucklingWeight {
                friction,
                operation: operation.kind,
                bit_depth_m,
                weights_N,
            });
        }
    }
    found
}

/// Returns an operation that drills, with the set points of another one.
fn drilling(operation: Operation, kind: OperationKind, bit_depth_m: f64) -> Operation {
    let or = |value: f64, usual: f64| if value > 0.0 { value } else { usual };
    Operation {
        kind,
        bit_depth_m,
        rotary_speed_rad_per_s: or(operation.rotary_speed_rad_per_s, USUAL_ROTATION_RAD_PER_S),
        rate_of_penetration_m_per_s: or(operation.rate_of_penetration_m_per_s, USUAL_RATE_M_PER_S),
        ..operation
    }
}

fn weights_N(string: &SoftString<'_>, operation: &Operation) -> Result<[Option<f64>; 2], NoAnswer> {
    let margins_N = |weight_N: f64| {
        match string.buckling_margins_N(&operation.weight_on_bit_N(weight_N)) {
            // Only a helix locks up.
            Err(SoftError::LocksUp { .. }) => Ok([f64::NEG_INFINITY; 2]),
            found => found,
        }
    };
    let unloaded = margins_N(0.0)?;
    let mut found = [None; 2];
    for shape in 0..2 {
        found[shape] = least(unloaded[shape], |weight_N| Ok(margins_N(weight_N)?[shape]))?;
    }
    Ok(found)
}

/// Returns the least weight without a margin; the margin falls as the weight grows. Without
/// friction it falls at the same rate, so that the margin is the step.
fn least(
    unloaded_N: f64,
    margin_N: impl Fn(f64) -> Result<f64, SoftError>,
) -> Result<Option<f64>, NoAnswer> {
    if unloaded_N <= 0.0 {
        return Ok(Some(0.0));
    }
    let (mut low, mut high) = ((0.0, unloaded_N), (0.0, unloaded_N));
    while high.1 > 0.0 {
        low = high;
        let next_N = low.0 + low.1.max(0.01 * low.0).max(LEAST_N);
        if next_N.is_nan() || next_N > MOST_N {
            return Ok(None);
        }
        high = (next_N, margin_N(next_N)?);
    }
    // The distance beyond the limit of a string that locks up has no finite value.
    let bounded = |margin_N: f64| margin_N.max(-unloaded_N);
    let ends = [low, high].map(|(weight_N, margin_N)| (weight_N, bounded(margin_N)));
    let bounded_margin = |weight_N: f64| margin_N(weight_N).map(bounded);
    Ok(Some(root(bounded_margin, ends, (PART * high.0).max(LEAST_N))?))
}
