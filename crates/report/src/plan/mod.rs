//! Contents of the page of a plan, and its pictures.

mod broomstick;
mod buckling;
mod campaign;
mod depth_figure;
mod figures;
mod limits;
mod measured;
mod mud;
mod overlay;
mod page;
mod peaks;
mod surface;
mod tables;

#[cfg(test)]
mod tests;

pub use broomstick::STROKES as FRICTION_STROKES;
pub use figures::{PLAN_PICTURES, plan_plots};
pub use page::plan_html;
pub use surface::{surface_limit_is_near, surface_limit_title};

use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_results::{
    PlanFatigue, PlanMeasured, PlanOverlay, PlanSurfaceLimit, PlanWear, UncertainSummary,
    UncertainTables,
};

use crate::{PageHead, Section, Severity, uncertain::Uncertain};

/// A plan as its page shows it. Numbers are SI; a value without an answer is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// Warnings.
    pub message: Option<String>,
    /// Models, the first drawn as lines, others as points.
    pub models: Vec<ModelKind>,
    /// Levels of friction, from the least to the most.
    pub levels: Vec<PlanLevel>,
    /// Hook load and torque: model after model, operation after operation, level after level.
    pub curves: Vec<PlanCurve>,
    /// Weights to buckle: operation after operation, level after level.
    pub buckling: Vec<BucklingCurve>,
    /// The mud, where it has a rheology.
    pub mud: Option<PlanMud>,
    /// Sections of the hole, from the surface down.
    pub hole: Vec<Section>,
    /// Weight of the block, N.
    pub block_N: Option<f64>,
    /// Allowable hook load and torque at the surface.
    pub surface_limits: Vec<PlanSurfaceLimit>,
    /// For each kind of limit and each operation the nearest one, kind after kind.
    pub limits: Vec<PlanLimitRow>,
    /// The checks that need attention, the most severe first, then the governing limit of each
    /// operation that is not among them.
    pub checks: Vec<PlanVerdict>,
    /// Limits that could not be checked, and the missing numbers, in SI, metric and field units.
    pub unchecked: [Vec<String>; 3],
    /// The parts of the campaign that fatigue and casing wear count, in the same units.
    pub counted: [Vec<String>; 3],
    /// The parts of the campaign that they do not count, with the reasons, in the same units.
    pub not_counted: [Vec<String>; 3],
    /// Fatigue of each component.
    pub fatigue: Vec<PlanFatigue>,
    /// For each casing the most worn stretch.
    pub wear: Vec<PlanWear>,
    /// Dynamic results of a string that is set in motion from rest.
    pub events: Vec<PlanEvent>,
    /// Weight on bit of operations that drill, N.
    pub weight_on_bit_N: Option<f64>,
    /// Effect of uncertain numbers; `None` where all are exact.
    pub uncertain: Option<UncertainSummary>,
    /// Measured readings, model after model.
    pub measured: Vec<PlanMeasured>,
    /// Another program's curves.
    pub overlay: Option<PlanOverlay>,
}

impl Plan {
    /// Effect of uncertain numbers; `None` where all are exact.
    fn samples(&self) -> Option<Uncertain<'_>> {
        Uncertain::new(self.uncertain.as_ref(), &UncertainTables::PLAN)
    }
}

/// A level of friction.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanLevel {
    /// `low`, `expected` or `high`.
    pub name: String,
    /// Label at the ends of its lines: `0.25`, or `0.2 / 0.3` for casing and rock.
    pub label: String,
    /// Each kind of hole with its coefficients of axial and rotational friction, as shown to users.
    pub sections: Vec<String>,
}

/// One operation by one model with one friction, down the hole.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanCurve {
    /// The model.
    pub model: ModelKind,
    /// The operation.
    pub operation: OperationKind,
    /// Place of its friction among [`Plan::levels`].
    pub level: usize,
    /// Depth after depth.
    pub points: Vec<PlanSpot>,
}

/// One operation at one depth.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanSpot {
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Hook load without block, N.
    pub hook_load_N: f64,
    /// Surface torque, N·m.
    pub torque_N_m: f64,
    /// `none`, `sinusoidal`, `helical`, or nothing.
    pub buckling: String,
    /// The most severe finding and its severity.
    pub worst: Option<(String, Severity)>,
    /// Reason why there is no answer, in SI, metric and field units.
    pub message: Option<[String; 3]>,
}

/// Weights on bit at which the string begins to buckle, down the hole.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingCurve {
    /// The operation: `drill` or `slide`.
    pub operation: OperationKind,
    /// Place of its friction among [`Plan::levels`].
    pub level: usize,
    /// Measured depth of the bit, m, and the weights of a sinusoid and of a helix, N.
    pub points: Vec<(f64, [f64; 2])>,
}

/// A load against its capacity.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanLimitRow {
    /// Whether exceeding it breaks something or stops the operation.
    pub breaks: bool,
    /// Kind of the limit.
    pub kind: String,
    /// The operation in words, or the event of the dynamic part.
    pub operation: String,
    /// Level of friction.
    pub friction: FrictionLevel,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The component; empty for the rig.
    pub component: String,
    /// Measured depth, m; `None` for the rig.
    pub md_m: Option<f64>,
    /// The load, SI.
    pub load: f64,
    /// The capacity, SI.
    pub capacity: f64,
    /// Dimension of both.
    pub dimension: String,
    /// Capacity over load.
    pub factor: f64,
    /// The required factor.
    pub required: f64,
    /// The verdict in words.
    pub verdict: String,
    /// Its severity.
    pub severity: Severity,
}

/// A check that needs attention, or the governing limit of an operation.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanVerdict {
    /// Its severity.
    pub severity: Severity,
    /// The verdict in words.
    pub verdict: String,
    /// Whether it is the limit with the least reserve of its operation.
    pub governs: bool,
    /// The model.
    pub model: ModelKind,
    /// The operation in words, or the event of the dynamic part.
    pub operation: String,
    /// Level of friction.
    pub friction: FrictionLevel,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The check as a sentence, in SI, metric and field units.
    pub sentences: [String; 3],
}

/// A string that is set in motion from rest, with the bit at one depth and one friction.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanEvent {
    /// Its name: `pick-up from slips`.
    pub name: String,
    /// Place of its friction among [`Plan::levels`].
    pub level: usize,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Its peaks; empty where there is no answer.
    pub peaks: Vec<PlanPeakRow>,
    /// Pressure that breaks the gel, Pa, where it is known.
    pub gel_Pa: Option<f64>,
    /// Reduction of the hook load by it, N.
    pub gel_lift_N: f64,
    /// Time from its beginning, s.
    pub time_s: Vec<f64>,
    /// Hook load without block, N.
    pub hook_load_N: Vec<f64>,
    /// Surface torque, N·m.
    pub torque_N_m: Vec<f64>,
    /// Pressure of the pump, Pa.
    pub pump_Pa: Vec<f64>,
    /// Reason why there is no answer, or a warning.
    pub message: Option<String>,
}

/// A peak; an unknown number is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanPeakRow {
    /// `hook load`, `surface torque` or `pump pressure`.
    pub quantity: &'static str,
    /// Its dimension.
    pub dimension: String,
    /// Before, SI.
    pub at_rest: f64,
    /// Sample farthest from that, SI.
    pub peak: f64,
    /// Time of the peak, s from the beginning.
    pub time_s: f64,
    /// Final value, SI.
    pub steady: f64,
    /// Peak over final value.
    pub ratio: f64,
    /// Excess of the peak over the final value, as a part of the change.
    pub overshoot: f64,
}

/// Pressures and densities of the mud in a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanMud {
    /// The operation whose pumps run.
    pub operation: OperationKind,
    /// Density of the mud at rest, kg/m³.
    pub density_kg_per_m3: f64,
    /// Limit of pumps and standpipe, Pa.
    pub pump_limit_Pa: Option<f64>,
    /// Depth after depth.
    pub rows: Vec<PlanMudRow>,
}

/// The mud with the bit at one depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanMudRow {
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Pressure at the standpipe, Pa.
    pub standpipe_Pa: f64,
    /// Equivalent density at the casing shoe, kg/m³: circulating, running in closed and open,
    /// pulling out closed and open; not a number without casing.
    pub at_shoe_kg_per_m3: [f64; 5],
    /// The same at the bit.
    pub at_bit_kg_per_m3: [f64; 5],
}

/// A limit beyond the curves by more than this factor is written, not drawn, because it would
/// flatten them.
const FAR: f64 = 1.35;

impl Plan {
    /// The curves of a model and an operation, from the least friction to the most.
    fn curves_of(
        &self,
        model: ModelKind,
        operation: OperationKind,
    ) -> impl Iterator<Item = &PlanCurve> {
        self.curves.iter().filter(move |curve| curve.model == model && curve.operation == operation)
    }

    /// The surface limits of a force or a torque; none for other dimensions.
    fn surface<'a>(&'a self, dimension: &'a str) -> impl Iterator<Item = &'a PlanSurfaceLimit> {
        let of_it = |limit: &&PlanSurfaceLimit| if limit.is_torque { "torque" } else { "force" };
        self.surface_limits.iter().filter(move |surface_limit| of_it(surface_limit) == dimension)
    }

    /// Operations in their order.
    fn operations(&self) -> Vec<OperationKind> {
        let mut operations: Vec<OperationKind> = Vec::new();
        for curve in &self.curves {
            if !operations.contains(&curve.operation) {
                operations.push(curve.operation);
            }
        }
        operations
    }
}
