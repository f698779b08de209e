//! Samples of a plan: the operations at every depth with expected friction, for the case with
//! sampled inputs.

use wholestring::{
    operation::{Operation, OperationKind},
    well::FrictionLevel,
};
use wholestring_judge::CheckKind;
use wholestring_plan::Broomstick;
use wholestring_results::{PlanBuckling, PlanCheck, PlanOperation, PlanPoint};

use crate::uncertain::{Quantity, Sampled, Sampler};

/// Quantities that each sample of a plan computes, in order.
pub(super) struct SampleSolver<'a> {
    sampler: &'a Sampler<'a>,
    kinds: Vec<OperationKind>,
    depths_m: &'a [f64],
}

/// Operations with a weight at which the string buckles.
const DRILLS: [OperationKind; 2] = [OperationKind::Drill, OperationKind::Slide];

impl<'a> SampleSolver<'a> {
    pub(super) fn new(
        sampler: &'a Sampler<'a>,
        operations: &[Operation],
        depths_m: &'a [f64],
    ) -> Self {
        Self {
            sampler,
            kinds: operations.iter().map(|operation| operation.kind).collect(),
            depths_m,
        }
    }

    /// Number of points with loads, whose answers come first.
    fn points(&self) -> usize {
        self.kinds.len() * self.depths_m.len()
    }

    fn answers(&self) -> usize {
        2 * self.points() + self.kinds.len() * CheckKind::LIMITS.len() + 2 * DRILLS.len()
    }

    /// Solves a sample.
    pub(super) fn solve(&self, sample: usize) -> Sampled {
        let none = |message: String| Sampled::none(self.answers(), self.points(), message);
        let case = match self.sampler.case(sample) {
            Ok(case) => case,
            Err(message) => return none(message),
        };
        let broomstick = match case.broomstick_at(self.depths_m.to_vec()) {
            Ok(broomstick) => broomstick,
            Err(error) => return none(error.to_string()),
        };
        let mut operations = Vec::new();
        for kind in &self.kinds {
            match case.plan.operations.iter().find(|operation| operation.kind == *kind) {
                Some(operation) => operations.push(*operation),
                None => return none(format!("it has no {}", kind.name())),
            }
        }
        let mut sampled = self.loads(&broomstick, &operations);
        let deepest_m = self.depths_m.last().copied().unwrap_or(0.0);
        let weights = broomstick.expected_weights_to_buckle(deepest_m);
        for kind in DRILLS {
            let found = weights.iter().find(|weight| weight.operation == kind);
            let found = found.and_then(|weight| weight.weights_N.as_ref().ok());
            sampled.answers.extend(found.map_or([None; 2], |weights_N| *weights_N));
        }
        sampled
    }

    /// Hook load and torque of each operation at every depth, followed by the least reserve of each
    /// kind of limit in each operation.
    fn loads(&self, broomstick: &Broomstick, operations: &[Operation]) -> Sampled {
        let by = self.sampler.uncertain.model;
        let mut reserves = vec![[None::<f64>; CheckKind::LIMITS.len()]; operations.len()];
        let mut found = Vec::new();
        // Calculations common to a depth are done once.
        for bit_depth_m in self.depths_m {
            let all = broomstick.expected_loads(by, *bit_depth_m, operations);
            for (loads, reserves) in all.into_iter().zip(&mut reserves) {
                if let Ok(loads) = &loads {
                    for limit in loads.limits.limits() {
                        let least = &mut reserves[limit.kind as usize];
                        let reserve = limit.reserve();
                        *least = Some(least.map_or(reserve, |least| least.min(reserve)));
                    }
                }
                found.push(loads.map(|load| [load.hook_load_N, load.surface_torque_N_m]));
            }
        }
        let mut sampled = Sampled::default();
        for (place, operation) in operations.iter().enumerate() {
            for loads in found.iter().skip(place).step_by(operations.len()) {
                sampled.answers.extend(loads.as_ref().map_or([None; 2], |load| load.map(Some)));
                if let Err(why) = loads {
                    sampled.lacks(|| format!("{}: {why}", operation.kind));
                }
            }
        }
        sampled.answers.extend(reserves.into_iter().flatten());
        sampled
    }

    /// Quantities in the order of the answers, with the plan's own values.
    pub(super) fn quantities(
        &self,
        points: &[PlanPoint],
        limits: &[PlanCheck],
        weights: &[PlanBuckling],
    ) -> Vec<Quantity> {
        let model = self.sampler.uncertain.model.kind();
        let mut all = Vec::new();
        for kind in &self.kinds {
            let of_kind = |point: &&PlanPoint| {
                point.model == model
                    && point.operation == *kind
                    && point.friction == FrictionLevel::Expected
            };
            let own: Vec<&PlanPoint> = points.iter().filter(of_kind).collect();
            for bit_depth_m in self.depths_m {
                let found = own.iter().find(|point| point.bit_depth_m == *bit_depth_m);
                let found = found.and_then(|point| point.scalars);
                let quantity = |name, unit, expected| Quantity {
                    bit_depth_m: Some(*bit_depth_m),
                    expected,
                    ..Quantity::new(name, Some(*kind), unit)
                };
                all.push(quantity("hook_load", "N", found.map(|scalars| scalars.hook_load_N)));
                let torque = found.map(|scalars| scalars.surface_torque_N_m);
                all.push(quantity("surface_torque", "N·m", torque));
            }
        }
        for kind in &self.kinds {
            let of_kind = |check: &&PlanCheck| {
                check.model == model
                    && check.operation == PlanOperation::Kind(*kind)
                    && check.friction == FrictionLevel::Expected
            };
            let own: Vec<&PlanCheck> = limits.iter().filter(of_kind).collect();
            for limit in CheckKind::LIMITS {
                let reserves = own.iter().filter(|reserve| reserve.check.kind == *limit);
                all.push(Quantity {
                    limit: limit.name(),
                    expected: reserves
                        .map(|reserve| reserve.check.reserve())
                        .filter(|reserve| reserve.is_finite())
                        .reduce(f64::min),
                    must_be: false,
                    ..Quantity::new("reserve", Some(*kind), "1")
                });
            }
        }
        let deepest_m = self.depths_m.last().copied();
        for kind in DRILLS {
            let own = weights.iter().find(|weight| {
                weight.operation == kind
                    && weight.friction == FrictionLevel::Expected
                    && Some(weight.bit_depth_m) == deepest_m
            });
            let quantity = |name, expected| Quantity {
                bit_depth_m: deepest_m,
                expected,
                must_be: false,
                ..Quantity::new(name, Some(kind), "N")
            };
            all.push(quantity(
                "sinusoidal_weight",
                own.and_then(|weight| weight.sinusoidal_weight_N),
            ));
            all.push(quantity("helical_weight", own.and_then(|weight| weight.helical_weight_N)));
        }
        all
    }
}
