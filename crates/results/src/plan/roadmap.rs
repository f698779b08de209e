//! The roadmap of a plan for the rig floor: hook loads and torques at even depths, between those
//! that were computed.

use wholestring::{
    operation::OperationKind,
    outcome::{ModelKind, Scalars},
    well::FrictionLevel,
};

use super::PlanSummary;

impl PlanSummary {
    /// Depths of the bit in the roadmap, m: the shallowest and the deepest that were computed, and
    /// all multiples of `spacing_m` between them.
    pub fn roadmap_depths_m(&self, spacing_m: f64) -> Vec<f64> {
        let [Some(first_m), Some(last_m)] =
            [self.bit_depths_m.first(), self.bit_depths_m.last()].map(|depth| depth.copied())
        else {
            return Vec::new();
        };
        let multiple = |index: f64| index * spacing_m;
        let (from, to) = ((first_m / spacing_m).floor() + 1.0, (last_m / spacing_m).ceil() - 1.0);
        let between = (0..).map(|index| from + f64::from(index)).take_while(|index| *index <= to);
        [first_m].into_iter().chain(between.map(multiple)).chain([last_m]).collect()
    }

    /// A scalar with the bit at a depth, in proportion between the two nearest depths that were
    /// computed; `None` where one of them has no answer.
    pub fn between_depths(
        &self,
        (model, operation, friction): (ModelKind, OperationKind, FrictionLevel),
        bit_depth_m: f64,
        scalar: impl Fn(&Scalars) -> f64,
    ) -> Option<f64> {
        let points: Vec<_> = self.curve(model, operation, friction).collect();
        let below = points.iter().position(|point| point.bit_depth_m >= bit_depth_m)?;
        let at = |place: usize| Some((points[place].bit_depth_m, scalar(&points[place].scalars?)));
        let (lower_m, lower) = at(below)?;
        if lower_m == bit_depth_m {
            return Some(lower);
        }
        let (upper_m, upper) = at(below.checked_sub(1)?)?;
        Some(upper + (lower - upper) * (bit_depth_m - upper_m) / (lower_m - upper_m))
    }
}
