//! The judge: derives the checks from a solver's result.

use wholestring::{
    dynamics::DynamicsSettings,
    model::Model,
    operation::Operation,
    outcome::{ModelKind, Profile, Solution},
    statics::{
        assembly::{Assembly, AssemblyNode},
        soft::{SoftError, SoftLoads, SoftProfile},
        stiff::StiffProfile,
    },
};
use wholestring_units::UnitSet;

use crate::{
    Check, CheckKind, Checks, DepthLimit, Descent, LimitSettings, Missing, NoAnswer, Severity,
    along, buckling, descent, hydraulics,
    loads::Loads,
    motion, numerics, rig,
    sentence::{Words, depth, unsolved},
    steadiness,
    strengths::{self, Strengths},
    unchecked, weight_on_bit,
    window::Window,
};

/// Compares results of the solvers with their limits and words the verdicts in the user's units.
///
/// Each method returns the checks of one operation, the most severe first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Judge {
    /// Settings of the limits.
    pub limits: LimitSettings,
    /// Units of the sentences.
    pub units: UnitSet,
    /// Whether the soft string counts the friction of its helix, so that it is not counted again
    /// here.
    pub soft_has_helix_friction: bool,
}

/// Lock-up factor of the soft string below which a stiff string that did not converge is said to be
/// near lock-up.
const NEAR_LOCK_UP: f64 = 1.2;

/// Behaviour of a string in static equilibrium after a small disturbance, friction and torque
/// apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Disturbed {
    /// Whether it stays where it is, its tool face held.
    pub keeps_its_shape: bool,
    /// Whether a bent string that does not rotate turns away from its tool face.
    pub leaves_its_tool_face: bool,
}

/// Depth that an operation reaches.
#[derive(Debug, Clone, Copy)]
pub struct Reached<'a> {
    /// The operation, as shown to users.
    pub operation: &'a str,
    /// Depth of the bit at which it is stopped, m, and the limit that stops it; `None` where none
    /// does.
    pub stopped: Option<(f64, DepthLimit)>,
    /// Depth of the bit from which on no weight hangs on the hook and the block or the rig pushes,
    /// m; `None` where the weight of the string drives it.
    pub pushed_from_m: Option<f64>,
    /// Whether a rig pushes whose purpose that is, which is no warning.
    pub rig_pushes: bool,
    /// First depth that was tried, m.
    pub from_m: f64,
    /// Depth of the bit of the case's operation, m, which a planned well must reach.
    pub planned_m: f64,
    /// Last depth that was tried, m.
    pub to_m: f64,
}

impl Judge {
    /// Creates a judge with these limits and units, for a soft string that leaves out the friction
    /// of its helix.
    pub fn new(limits: LimitSettings, units: UnitSet) -> Self {
        Self { limits, units, soft_has_helix_friction: false }
    }

    /// The checks of a soft string.
    pub fn soft(&self, model: &Model, operation: &Operation, profile: &SoftProfile) -> Checks {
        let solution = Solution::from(profile);
        let mut checks = self.at_rest(model, operation, &solution);
        checks.checks.extend(unchecked::lateral_force_left_out(model));
        self.worded(checks, model, &solution)
    }

    /// The checks of a stiff string.
    pub fn stiff(&self, model: &Model, operation: &Operation, profile: &StiffProfile) -> Checks {
        let solution = Solution::from(profile);
        let mut checks = self.at_rest(model, operation, &solution);
        let bows = bows_in_vertical_hole(model, operation, solution.profile);
        checks.checks.extend(numerics::equilibrium(&profile.convergence, bows));
        checks.checks.extend(numerics::helix(&profile.convergence, &profile.scalars));
        let element = profile.convergence.buckled_element.as_ref();
        checks.checks.extend(numerics::element_buckles(element));
        let deepest = profile.deepest_penetration_m;
        checks.checks.extend(numerics::penetration_at_rest(model, deepest));
        self.worded(checks, model, &solution)
    }

    /// The checks of a dynamic run that was computed to its end; none for a run without a sample in
    /// its window.
    pub fn dynamic(
        &self,
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        solution: &Solution<'_>,
    ) -> Checks {
        let Some(window) = Window::of_solution(solution) else {
            return Checks::default();
        };
        let mut checks = Checks::default();
        let descent = Descent::in_time(model, operation, &window);
        let mean = window.statistic("hook_load_N").map(|statistic| statistic.mean);
        let hook_load_N = mean.unwrap_or(solution.scalars.hook_load_N);
        let goes_down = descent::goes_down(model, operation, hook_load_N, descent.as_ref());
        let slack = || descent::goes_slack(model, &window);
        checks.checks.extend(goes_down.filter(|check| !check.is_ok()).or_else(slack));
        // The margin to lock-up of a moving string is not known: the part that its hook load leaves
        // is friction.
        let locked = descent.as_ref().filter(|descent| descent.locks_up);
        let words = self.words(model, solution).of_run(settings);
        checks.checks.extend(self.lock_up(model, operation, locked, &words));
        checks.checks.extend(weight_on_bit::checks(operation, settings, &window));
        self.add_limits(model, operation, &Loads::of(model, operation, solution), &mut checks);
        checks.checks.extend(motion::checks(settings, &window));
        checks.checks.extend(numerics::checks(model, operation, solution, &window));
        checks.checks.extend(steadiness::checks(operation, settings, &window));
        self.with_sentences(checks, &words)
    }

    /// The checks of a bottom-hole assembly in static equilibrium: the largest von Mises stress of
    /// each component, whether the equilibrium is stable, and by the soft string whether the string
    /// above carries the assembly down.
    pub fn assembly(
        &self,
        model: &Model,
        operation: &Operation,
        assembly: &Assembly,
        soft: &Result<SoftProfile, SoftError>,
    ) -> Checks {
        let kind = CheckKind::VonMises;
        let mut checks = Checks::default();
        match soft {
            Ok(profile) => {
                let solution = Solution::from(profile);
                let surface_N = [solution.scalars.hook_load_N, solution.scalars.axial_friction_N];
                let descent = self.descent(model, operation, &solution);
                let words = self.words(model, &solution);
                self.add_descent(
                    model,
                    operation,
                    surface_N,
                    descent.as_ref(),
                    &words,
                    &mut checks,
                );
            }
            Err(error) => checks.checks.push(self.no_answer(&NoAnswer::Soft(error.clone()))),
        }
        for (index, component) in model.string.components().iter().enumerate() {
            let nodes = assembly.nodes.iter().filter(|node| node.component == index);
            let stress_Pa = |node: &&AssemblyNode| node.von_mises_stress_Pa;
            let Some(worst) = nodes.max_by(|a, b| stress_Pa(a).total_cmp(&stress_Pa(b))) else {
                continue;
            };
            let name = component.name.as_str();
            match component.yield_strength_Pa {
                Some(yield_Pa) => {
                    let required = self.limits.factors.von_mises;
                    let check = Check::load(kind, stress_Pa(&worst), yield_Pa, required);
                    let placed = |check: Check| check.of_component(name).at(worst.md_m);
                    checks.checks.extend(check.map(placed));
                }
                None if component.is_bit() => {}
                None => checks.lacks(kind, Some(name), Missing::YieldStrength),
            }
        }
        let tensions = assembly.nodes.iter().map(|node| (node.md_m, node.tension_N));
        let bows = buckling::bows_in_vertical_hole(model, operation, tensions);
        checks.checks.extend(numerics::equilibrium(&assembly.convergence, bows));
        let words = Words::of_loads(&model.rig, f64::NAN);
        self.with_sentences(checks, &words)
    }

    /// The checks of a string whose linear vibration about static equilibrium grows or decays, with
    /// the tensions of its soft string.
    pub fn small_motions(
        &self,
        model: &Model,
        operation: &Operation,
        profile: &SoftProfile,
        disturbed: Disturbed,
    ) -> Checks {
        let bows = bows_in_vertical_hole(model, operation, Solution::from(profile).profile);
        let mut checks: Vec<Check> =
            numerics::unstable(disturbed.keeps_its_shape, bows).into_iter().collect();
        checks.extend(numerics::unstable_tool_face(disturbed.leaves_its_tool_face));
        let words = Words::of_loads(&model.rig, f64::NAN);
        self.with_sentences(Checks { checks, unchecked: Vec::new() }, &words)
    }

    /// The check of the depth that an operation reaches: the depth of the bit, m, at which a limit
    /// stops it, or the last depth that was tried, `to_m`. An operation that is stopped at the
    /// first depth already, or above the planned depth, is an error.
    pub fn reach(&self, reach: &Reached<'_>) -> Check {
        let Reached { operation, stopped, pushed_from_m, rig_pushes, to_m, from_m, planned_m } =
            *reach;
        let end_m = stopped.map_or(to_m, |(depth_m, _)| depth_m);
        // As `goes_down`: a string that only the block pushes is warned of.
        let pushed_from_m = pushed_from_m.filter(|depth_m| *depth_m < end_m);
        let severity = match stopped {
            None if pushed_from_m.is_none() || rig_pushes => Severity::Ok,
            Some((depth_m, _)) if depth_m <= from_m || depth_m < planned_m => Severity::Error,
            _ if pushed_from_m.is_some() && !rig_pushes => Severity::Warning,
            _ => Severity::Note,
        };
        let mut sentence = match stopped.map(|(depth_m, limit)| (depth_m, limit.title())) {
            None => format!("{operation}: nothing stops it down to {}", depth(to_m)),
            Some((depth_m, limit)) if depth_m <= from_m => {
                format!("{operation}: stopped at {} already: {limit}", depth(depth_m))
            }
            Some((depth_m, limit)) if depth_m < planned_m => {
                let [at, planned] = [depth_m, planned_m].map(depth);
                format!("{operation}: stopped at {at}, short of the planned {planned}: {limit}")
            }
            Some((depth_m, limit)) => {
                format!("{operation}: goes to {}, where it is stopped: {limit}", depth(depth_m))
            }
        };
        if let Some(depth_m) = pushed_from_m {
            let from = depth(depth_m.max(from_m));
            sentence += &format!("; from {from} on it must be pushed: no weight hangs on the hook");
        }
        let check = Check::reported(CheckKind::Reach, severity).value(end_m).limit(to_m);
        check.worded(sentence).in_units(self.units)
    }

    /// The reason why a model has no result, in a sentence.
    pub fn reason(&self, why: &NoAnswer) -> String {
        self.no_answer(why).sentence
    }

    /// The verdict on an operation for which a model has no result.
    pub fn unsolved(&self, why: &NoAnswer) -> Checks {
        Checks { checks: vec![self.no_answer(why)], unchecked: Vec::new() }
    }

    fn no_answer(&self, why: &NoAnswer) -> Check {
        let check = why.check(&self.limits);
        let sentence = unsolved(why, &check);
        check.worded(sentence).in_units(self.units)
    }

    /// The same with the soft string of the operation, where it has one: its sentence adds how near
    /// to lock-up that is, because the iterations of a stiff string may end without convergence
    /// shortly before.
    pub fn unsolved_beside(
        &self,
        why: &NoAnswer,
        model: &Model,
        operation: &Operation,
        soft: Option<&SoftProfile>,
    ) -> Checks {
        let mut checks = self.unsolved(why);
        if !why.is_not_converged() {
            return checks;
        }
        let soft_checks = soft.map(|profile| self.soft(model, operation, profile).checks);
        let mut soft_checks = soft_checks.iter().flatten();
        let lock_up = soft_checks.find(|check| check.kind == CheckKind::LockUp);
        let factor = lock_up.and_then(|check| check.factor);
        if let Some(factor) = factor.filter(|factor| *factor < NEAR_LOCK_UP) {
            let more = format!(
                ". The string is near lock-up, where its shape changes much with a small force: the \
                 soft string's lock-up factor is {factor:.2}, that of a string that locks up 1. Use \
                 the soft string here, or give less friction or a lighter weight on bit"
            );
            let all = checks.checks.into_iter();
            checks.checks = all.map(|check| check.continued(&more).in_units(self.units)).collect();
        }
        checks
    }

    /// The strength of the string and the limits of the rig alone, without sentences: for a search
    /// over many depths.
    pub fn load_limits(
        &self,
        model: &Model,
        operation: &Operation,
        solution: &Solution<'_>,
    ) -> Checks {
        let mut checks = Checks::default();
        let loads = Loads::of(model, operation, solution);
        let strengths = Strengths::of(model, &mut checks);
        along::limits(model, &strengths, &loads, &self.limits, &mut checks);
        rig::limits(model, operation, &loads, &self.limits, &mut checks);
        checks
    }

    /// The limits of any result, and whether the string goes down.
    pub fn limits(&self, model: &Model, operation: &Operation, solution: &Solution<'_>) -> Checks {
        let checks = match solution.in_time {
            None => self.at_rest(model, operation, solution),
            Some(_) => {
                let mut checks = Checks::default();
                let loads = Loads::of(model, operation, solution);
                self.add_limits(model, operation, &loads, &mut checks);
                checks
            }
        };
        self.worded(checks, model, solution)
    }

    /// The same for a soft string of which only the loads are known.
    pub fn soft_limits(&self, model: &Model, operation: &Operation, loads: &SoftLoads) -> Checks {
        let mut checks = Checks::default();
        let surface_N = [loads.hook_load_N, loads.axial_friction_N];
        let helix = self.soft_has_helix_friction;
        let descent = Descent::at_rest(model, operation, surface_N, &loads.profile, helix);
        let words = Words::of_loads(&model.rig, loads.hook_load_N);
        self.add_descent(model, operation, surface_N, descent.as_ref(), &words, &mut checks);
        self.add_limits(model, operation, &Loads::of_soft(model, operation, loads), &mut checks);
        self.with_sentences(checks, &words)
    }

    /// Whether and how the string goes down; `None` for one that does not slide down.
    pub fn descent(
        &self,
        model: &Model,
        operation: &Operation,
        solution: &Solution<'_>,
    ) -> Option<Descent> {
        match Window::of_solution(solution) {
            Some(window) => Descent::in_time(model, operation, &window),
            None => {
                let scalars = solution.scalars;
                let surface_N = [scalars.hook_load_N, scalars.axial_friction_N];
                let helix = self.has_helix_friction(solution.model);
                Descent::at_rest(model, operation, surface_N, solution.profile, helix)
            }
        }
    }

    fn has_helix_friction(&self, model: ModelKind) -> bool {
        model.method().has_helix_friction
            || model == ModelKind::Soft && self.soft_has_helix_friction
    }

    /// The checks of a static equilibrium, without sentences except that of lock-up.
    fn at_rest(&self, model: &Model, operation: &Operation, solution: &Solution<'_>) -> Checks {
        let mut checks = Checks::default();
        let surface_N = [solution.scalars.hook_load_N, solution.scalars.axial_friction_N];
        let descent = self.descent(model, operation, solution);
        let words = self.words(model, solution);
        self.add_descent(model, operation, surface_N, descent.as_ref(), &words, &mut checks);
        self.add_limits(model, operation, &Loads::of(model, operation, solution), &mut checks);
        checks
    }

    /// Adds whether a string goes down, for a static equilibrium with this hook load and axial
    /// friction, N.
    fn add_descent(
        &self,
        model: &Model,
        operation: &Operation,
        surface_N: [f64; 2],
        descent: Option<&Descent>,
        words: &Words<'_>,
        checks: &mut Checks,
    ) {
        if let Some(check) = descent::weight_not_available(model, operation, surface_N) {
            checks.checks.push(check);
            return;
        }
        let goes_down = descent::goes_down(model, operation, surface_N[0], descent);
        checks.checks.extend(goes_down.map(|check| {
            let sentence = words.goes_down(&check, descent);
            check.worded(sentence)
        }));
        checks.checks.extend(self.lock_up(model, operation, descent, words));
    }

    fn lock_up(
        &self,
        model: &Model,
        operation: &Operation,
        descent: Option<&Descent>,
        words: &Words<'_>,
    ) -> Option<Check> {
        let descent = descent?;
        let check = descent.lock_up(model, operation, &self.limits)?;
        let sentence = words.lock_up(descent, &check);
        Some(check.worded(sentence))
    }

    fn add_limits(
        &self,
        model: &Model,
        operation: &Operation,
        loads: &Loads<'_>,
        checks: &mut Checks,
    ) {
        let strengths = Strengths::of(model, checks);
        along::limits(model, &strengths, loads, &self.limits, checks);
        strengths::side_force_limits(model, loads, &self.limits, checks);
        strengths::overpull_limits(model, operation, &strengths, loads, &self.limits, checks);
        rig::limits(model, operation, loads, &self.limits, checks);
        checks.checks.extend(loads.hydraulics.as_ref().and_then(hydraulics::implausible));
        let line = buckling::Line::of(model, operation, loads.profile);
        checks.checks.extend(buckling::checks(&line, &self.limits));
    }

    fn words<'a>(&self, model: &'a Model, solution: &Solution<'a>) -> Words<'a> {
        let helix = self.has_helix_friction(solution.model);
        Words::of_solution(&model.rig, solution, helix)
    }

    fn worded(&self, checks: Checks, model: &Model, solution: &Solution<'_>) -> Checks {
        self.with_sentences(checks, &self.words(model, solution))
    }

    /// The same checks, all in words and in the user's units.
    pub(crate) fn with_sentences(&self, mut checks: Checks, words: &Words<'_>) -> Checks {
        let worded = |check: Check| match check.sentence.is_empty() {
            true => {
                let sentence = words.sentence(&check);
                check.worded(sentence)
            }
            false => check,
        };
        let all = checks.checks.into_iter();
        checks.checks = all.map(|check| worded(check).in_units(self.units)).collect();
        checks.ordered()
    }
}

fn bows_in_vertical_hole(model: &Model, operation: &Operation, profile: &Profile) -> bool {
    let tensions = profile.md_m.iter().copied().zip(profile.tension_N.iter().copied());
    buckling::bows_in_vertical_hole(model, operation, tensions)
}
