//! Results of a plan grouped into curves against the depth of the bit.

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_results::{PlanBuckling, PlanPoint};

use super::{Plan, levels::Level};

/// One operation by one model with one friction, down the hole.
pub(super) struct Curve<'a> {
    /// The model.
    pub(super) model: ModelKind,
    /// The operation.
    pub(super) operation: OperationKind,
    /// Its level of friction.
    pub(super) level: &'a Level,
    /// Depth after depth.
    pub(super) points: Vec<&'a PlanPoint>,
}

/// Weights on bit at which the string begins to buckle, down the hole.
pub(super) struct BucklingCurve<'a> {
    /// The operation: `drill` or `slide`.
    pub(super) operation: OperationKind,
    /// Its level of friction.
    pub(super) level: &'a Level,
    /// Depth after depth.
    pub(super) points: Vec<&'a PlanBuckling>,
}

impl Plan {
    /// Every curve: model after model, operation after operation, from the least friction to the
    /// most.
    pub(super) fn curves(&self) -> impl Iterator<Item = Curve<'_>> {
        let models = self.summary.models.iter().copied();
        models.flat_map(move |model| {
            self.operations().flat_map(move |operation| self.curves_of(model, operation))
        })
    }

    /// The curves of a model and an operation, from the least friction to the most.
    pub(super) fn curves_of(
        &self,
        model: ModelKind,
        operation: OperationKind,
    ) -> impl Iterator<Item = Curve<'_>> {
        self.levels.iter().map(move |level| {
            let points = self.summary.curve(model, operation, level.friction).collect();
            Curve { model, operation, level, points }
        })
    }

    /// Weights to buckle: operation after operation, from the least friction to the most.
    pub(super) fn buckling_curves(&self) -> impl Iterator<Item = BucklingCurve<'_>> {
        let operations = [OperationKind::Drill, OperationKind::Slide].into_iter();
        operations.flat_map(move |operation| {
            self.levels.iter().map(move |level| {
                let points = self.summary.buckling.iter().filter(|point| {
                    point.operation == operation && point.friction == level.friction
                });
                BucklingCurve { operation, level, points: points.collect() }
            })
        })
    }
}

/// Hook load without block, N; not a number without an answer.
pub(super) fn hook_load_N(point: &PlanPoint) -> f64 {
    point.scalars.map_or(f64::NAN, |scalars| scalars.hook_load_N)
}

/// Surface torque, N·m; not a number without an answer.
pub(super) fn surface_torque_N_m(point: &PlanPoint) -> f64 {
    point.scalars.map_or(f64::NAN, |scalars| scalars.surface_torque_N_m)
}

/// Weights on bit of a sinusoid and of a helix, N; not a number where no weight buckles the string.
pub(super) fn buckling_weights_N(point: &PlanBuckling) -> [f64; 2] {
    [point.sinusoidal_weight_N, point.helical_weight_N].map(|weight| weight.unwrap_or(f64::NAN))
}
