//! What a page reports of a plan, and its pictures.

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
mod tables;
#[cfg(test)]
mod tests;

pub use broomstick::STROKES as FRICTION_STROKES;
pub use figures::{PLAN_PICTURES, plan_plots};
pub use page::plan_html;

use crate::{PageHead, Section, Severity, Uncertain};

/// A plan as its page shows it. Numbers are SI; what has no answer is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Under the name of the case.
    pub head: PageHead,
    /// Warnings.
    pub message: Option<String>,
    /// Models by their names, the first drawn as lines, others as points.
    pub models: Vec<String>,
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
    /// What hook load and torque may come to at the surface.
    pub surface_limits: Vec<PlanSurfaceLimit>,
    /// Of each kind of limit and each operation the nearest one, kind after kind.
    pub limits: Vec<PlanLimitRow>,
    /// The checks that need attention, the most severe first.
    pub checks: Vec<PlanVerdict>,
    /// Of each operation what would break first, in sentences, in SI, metric and field units.
    pub first: [Vec<String>; 3],
    /// What could not be checked, and what is missing for it.
    pub unchecked: Vec<String>,
    /// The parts of the campaign that fatigue and casing wear count.
    pub counted: Vec<String>,
    /// The parts of the campaign that they do not count, with the reasons.
    pub not_counted: Vec<String>,
    /// Fatigue of each component.
    pub fatigue: Vec<PlanFatigueRow>,
    /// Of each casing the stretch that is worn most.
    pub wear: Vec<PlanWearRow>,
    /// What the dynamics says of a string that sets itself in motion.
    pub events: Vec<PlanEvent>,
    /// Weight on bit of what drills, N.
    pub weight_on_bit_N: Option<f64>,
    /// What comes of numbers that are not known exactly; none where all are.
    pub uncertain: Option<Uncertain>,
    /// What was measured, model after model.
    pub measured: Vec<PlanMeasured>,
    /// Another program's curves.
    pub overlay: Option<PlanOverlay>,
}

/// Another program's curves of a file, and how far ours lie from them.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanOverlay {
    /// Name of the file.
    pub file: String,
    /// Model after model, operation after operation, down the hole.
    pub rows: Vec<PlanOverlayRow>,
    /// Of each model, operation and quantity.
    pub differences: Vec<PlanOverlayDifference>,
}

/// A weight or torque of another program.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanOverlayRow {
    /// Name of our model beside it.
    pub model: String,
    /// Name of the operation.
    pub operation: String,
    /// Whether it is a torque and no hook load.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// N or N·m.
    pub theirs: f64,
}

impl PlanOverlayRow {
    fn dimension(&self) -> &'static str {
        if self.is_torque { "torque" } else { "force" }
    }
}

/// How far ours lies from theirs.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanOverlayDifference {
    /// Name of our model.
    pub model: String,
    /// Name of the operation.
    pub operation: String,
    /// Whether of torques and not of hook loads.
    pub is_torque: bool,
    /// At how many depths both are known.
    pub count: usize,
    /// Mean of ours less theirs, N or N·m.
    pub mean: f64,
    /// The one that is farthest from zero.
    pub largest: f64,
    /// Measured depth of the bit there, m.
    pub largest_at_m: f64,
    /// Theirs there.
    pub theirs_there: f64,
    /// The largest as a part of theirs; none where theirs is zero.
    pub largest_part: Option<f64>,
}

/// A weight or torque that was read, beside what a model makes of it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanMeasured {
    /// Name of the model.
    pub model: String,
    /// Where it stands in its file.
    pub place: String,
    /// Name of the operation.
    pub operation: String,
    /// Whether it is a torque and no weight.
    pub is_torque: bool,
    /// Held out of a calibration.
    pub held_out: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// As it was read, N or N·m; weights with the block's.
    pub measured: f64,
    /// Weight of the block that it holds, N.
    pub block_N: f64,
    /// The same with low, expected and high friction; not a number without an answer.
    pub predicted: [f64; 3],
    /// Whether it lies between the first and the last; none where friction does not move it.
    pub between: Option<bool>,
    /// Why there is no answer.
    pub message: Option<String>,
}

impl PlanMeasured {
    fn dimension(&self) -> &'static str {
        if self.is_torque { "torque" } else { "force" }
    }
}

/// A level of friction.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanLevel {
    /// `low`, `expected` or `high`.
    pub name: String,
    /// What stands at the ends of its lines: `0.25`, or `0.2 / 0.3` of casing and rock.
    pub label: String,
    /// Each kind of hole with its coefficients along the hole and around it, as people read them.
    pub sections: Vec<String>,
}

/// One operation by one model with one friction, down the hole.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanCurve {
    /// Name of the model.
    pub model: String,
    /// Name of the operation.
    pub operation: String,
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
    /// Why there is no answer.
    pub message: Option<String>,
}

/// Weights on bit under which the string begins to buckle, down the hole.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingCurve {
    /// `drill` or `slide`.
    pub operation: String,
    /// Place of its friction among [`Plan::levels`].
    pub level: usize,
    /// Measured depth of the bit, m, and the weights of a sinusoid and of a helix, N.
    pub points: Vec<(f64, [f64; 2])>,
}

/// A load against what bears it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanLimitRow {
    /// Whether something breaks or stops where it is passed.
    pub breaks: bool,
    /// What it is of.
    pub kind: String,
    /// Name of the operation.
    pub operation: String,
    /// `low`, `expected` or `high`.
    pub friction: String,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The component; empty of the rig.
    pub component: String,
    /// Where, measured depth in m; none of the rig.
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
    /// How serious it is.
    pub severity: Severity,
}

/// A check that needs attention.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanVerdict {
    /// How serious it is.
    pub severity: Severity,
    /// The verdict in words.
    pub verdict: String,
    /// What is compared or reported, for people.
    pub label: String,
    /// Name of the model.
    pub model: String,
    /// `trip_out`, `drill`, ...
    pub operation: String,
    /// `low`, `expected` or `high`.
    pub friction: String,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The check as a sentence, in the units of the case.
    pub sentence: String,
}

/// Fatigue of a component.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanFatigueRow {
    /// Name of the model.
    pub model: String,
    /// The component.
    pub component: String,
    /// Part of its life that the campaign takes.
    pub damage: f64,
    /// What an hour of drilling costs at the deepest depth; none where nothing drills.
    pub hour: Option<PlanFatigueHourRow>,
}

/// What an hour of drilling costs where it costs most.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanFatigueHourRow {
    /// Measured depth, m.
    pub md_m: f64,
    /// Part of the life that goes.
    pub damage_per_hour: f64,
    /// Amplitude of the bending stress, Pa.
    pub bending_Pa: f64,
    /// Dogleg severity of the hole and the permissible one, rad/m.
    pub doglegs_rad_per_m: [f64; 2],
}

/// Wear of a casing where it is worn most; what is not known is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanWearRow {
    /// Name of the model.
    pub model: String,
    /// Section of the hole, counted from one.
    pub section: usize,
    /// Measured depth, m.
    pub md_m: f64,
    /// Depth of the groove, m.
    pub groove_m: f64,
    /// Wall that is left, m.
    pub wall_left_m: f64,
    /// Part of the wall that is gone.
    pub worn: f64,
    /// Burst of the new and of the worn casing, Pa.
    pub burst_Pa: [f64; 2],
    /// Collapse of the new and of the worn casing, Pa.
    pub collapse_Pa: [f64; 2],
}

/// A string that sets itself in motion, with the bit at one depth and one friction.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanEvent {
    /// What it is: `pick-up from slips`.
    pub name: String,
    /// Place of its friction among [`Plan::levels`].
    pub level: usize,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Its peaks; none where there is no answer.
    pub peaks: Vec<PlanPeakRow>,
    /// What breaks the gel, Pa, where it is known.
    pub gel_Pa: Option<f64>,
    /// What that takes off the hook load, N.
    pub gel_lift_N: f64,
    /// Time from its beginning, s.
    pub time_s: Vec<f64>,
    /// Hook load without block, N.
    pub hook_load_N: Vec<f64>,
    /// Surface torque, N·m.
    pub torque_N_m: Vec<f64>,
    /// Pressure of the pump, Pa.
    pub pump_Pa: Vec<f64>,
    /// Why there is no answer, or a warning.
    pub message: Option<String>,
}

/// A peak; what is not known is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanPeakRow {
    /// `hook load`, `surface torque` or `pump pressure`.
    pub quantity: &'static str,
    /// Its dimension.
    pub dimension: String,
    /// Before, SI.
    pub at_rest: f64,
    /// Farthest from that, SI.
    pub peak: f64,
    /// When, s from the beginning.
    pub time_s: f64,
    /// What it comes to, SI.
    pub steady: f64,
    /// Peak over that.
    pub ratio: f64,
    /// What the peak has beyond that, as a part of the change.
    pub overshoot: f64,
}

/// What the mud does in a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanMud {
    /// Name of the operation whose pumps run.
    pub operation: String,
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
    /// Equivalent density at the casing shoe, kg/m³: circulating, running in closed and open, pulling
    /// out closed and open; not a number without casing.
    pub at_shoe_kg_per_m3: [f64; 5],
    /// The same at the bit.
    pub at_bit_kg_per_m3: [f64; 5],
}

/// What hook load or torque may come to at the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanSurfaceLimit {
    /// What the line is called: `hoist`, `pipe, torsion`, ...
    pub title: String,
    /// Whether it is of torque and not of hook load.
    pub is_torque: bool,
    /// N without the block, or N·m, with the factor that is required.
    pub allowed: f64,
}

/// A limit farther beyond the curves than this part of them is told, not drawn: it would flatten
/// them.
const FAR: f64 = 1.35;

impl PlanSurfaceLimit {
    /// Whether it is drawn beside curves that come to so much.
    pub fn is_near(&self, largest: f64) -> bool {
        self.allowed <= FAR * largest
    }
}

impl Plan {
    /// The curves of a model and an operation, from the least friction to the most.
    fn of<'a>(&'a self, model: &'a str, operation: &'a str) -> impl Iterator<Item = &'a PlanCurve> {
        self.curves.iter().filter(move |of| of.model == model && of.operation == operation)
    }

    /// What a force or a torque may come to at the surface; nothing of other dimensions.
    fn surface<'a>(&'a self, dimension: &'a str) -> impl Iterator<Item = &'a PlanSurfaceLimit> {
        let of_it = |of: &&PlanSurfaceLimit| if of.is_torque { "torque" } else { "force" };
        self.surface_limits.iter().filter(move |of| of_it(of) == dimension)
    }

    /// Operations in their order.
    fn operations(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for of in &self.curves {
            if !names.contains(&of.operation.as_str()) {
                names.push(&of.operation);
            }
        }
        names
    }
}
