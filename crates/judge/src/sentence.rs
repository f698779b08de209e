//! Checks in words, in users' units.

mod limits;
mod states;
#[cfg(test)]
mod tests;
mod text;

use wholestring::{
    dynamics::{DynamicsSettings, HoistControl, Indicators, Statistic, TableUse},
    outcome::{ModelKind, Solution},
    rig::Rig,
    rod::buckled_element::BuckledElement,
    statics::stiff::StiffError,
};
use wholestring_units::UnitSet;

use crate::{Check, CheckKind, NoAnswer, Wording};

pub(crate) use self::text::depth;

/// Data that sentences need in addition to a check.
pub(crate) struct Words<'a> {
    rig: &'a Rig,
    model: ModelKind,
    /// Whether the result's forces include the friction of a helix.
    has_helix_friction: bool,
    /// Hook load, block excluded, N; for a dynamic run its mean.
    hook_load_N: f64,
    /// Weight on bit, N; for a dynamic run its mean.
    weight_on_bit_N: f64,
    /// Hook load that the hoist holds, block excluded, N; `None` where it holds something else.
    held_hook_load_N: Option<f64>,
    indicators: Option<&'a Indicators>,
    bit_table: Option<TableUse>,
    statistics: &'a [(&'static str, Statistic)],
    bit_travel_m: f64,
    /// The element of the mesh that buckles between its nodes; `None` without one.
    buckled_element: Option<BuckledElement>,
}

impl<'a> Words<'a> {
    /// The words for a result.
    pub(crate) fn of_solution(
        rig: &'a Rig,
        solution: &Solution<'a>,
        has_helix_friction: bool,
    ) -> Self {
        Self {
            rig,
            model: solution.model,
            has_helix_friction,
            hook_load_N: solution.scalars.hook_load_N,
            weight_on_bit_N: solution.scalars.weight_on_bit_N,
            held_hook_load_N: None,
            indicators: solution.in_time.map(|run| run.indicators),
            bit_table: solution.in_time.and_then(|run| run.bit_table),
            statistics: solution.in_time.map_or(&[], |run| run.statistics),
            bit_travel_m: solution.in_time.map_or(0.0, |run| run.numerics.bit_travel_m),
            buckled_element: solution
                .in_time
                .and_then(|run| run.numerics.buckled_element)
                .or(solution.at_rest.and_then(|rest| rest.convergence.buckled_element)),
        }
    }

    /// The words for a soft string of which only the loads are known.
    pub(crate) fn of_loads(rig: &'a Rig, hook_load_N: f64) -> Self {
        Self {
            rig,
            model: ModelKind::Soft,
            has_helix_friction: false,
            hook_load_N,
            weight_on_bit_N: f64::NAN,
            held_hook_load_N: None,
            indicators: None,
            bit_table: None,
            statistics: &[],
            bit_travel_m: 0.0,
            buckled_element: None,
        }
    }

    /// The words for a live string.
    pub(crate) fn of_motion(rig: &'a Rig, hook_load_N: f64, indicators: &'a Indicators) -> Self {
        let indicators = Some(indicators);
        Self { model: ModelKind::Dynamic, indicators, ..Self::of_loads(rig, hook_load_N) }
    }

    /// The same words for a run with these settings.
    pub(crate) fn of_run(self, settings: &DynamicsSettings) -> Self {
        let held_hook_load_N = match settings.hoist_control {
            Some(HoistControl::HookLoad(hook_load_N)) => Some(hook_load_N),
            _ => None,
        };
        Self { held_hook_load_N, ..self }
    }

    /// A sentence with marked quantities that begins with a capital and ends without a full stop.
    pub(crate) fn sentence(&self, check: &Check) -> String {
        match check.kind {
            CheckKind::HelicalBuckling | CheckKind::SinusoidalBuckling => self.buckling(check),
            CheckKind::Collapse if check.limit.is_none() => self.beyond_collapse(check),
            kind if kind.is_limit() => self.limit(check),
            _ => self.state(check),
        }
    }
}

/// `2.4 m`: a length of elements that do not buckle where one has, rounded down to two digits.
pub fn shorter_element(element: &BuckledElement, units: UnitSet) -> String {
    Wording::from(text::element_length(element.sufficient_length_m()).to_string()).in_units(units)
}

/// The sentence on an operation without a result.
pub(crate) fn unsolved(why: &NoAnswer, check: &Check) -> String {
    let place = text::place(check);
    match why {
        NoAnswer::Assembly(error) => format!("The string does not fit: {error}"),
        NoAnswer::Stiff(StiffError::Rolls { .. }) => format!(
            "No static equilibrium: whirls{place}; released, the string rolls up the wall. The \
             dynamics compute its whirl"
        ),
        NoAnswer::Stiff(StiffError::ElementBuckles { compression_N, length_m, .. }) => format!(
            "An element of {} buckles between its nodes{place} under a compression of {}: shorter \
             elements are needed",
            text::length(*length_m),
            text::force(*compression_N)
        ),
        NoAnswer::Stiff(StiffError::ThroughWall { penetration_m, clearance_m, .. }) => format!(
            "The string is pressed {} into the wall{place}, farther than its mean clearance of {}: give \
             a larger `contact_stiffness`, or the contact law \"hertz\"",
            text::across(*penetration_m),
            text::across(*clearance_m)
        ),
        NoAnswer::Stiff(StiffError::NotConverged { residual_N, iterations, .. }) => format!(
            "Did not converge: forces are out of balance by {}{place} after {iterations} iterations. \
             The soft string or the dynamics may have an answer. With another \
             `mesh.element_length` the stiff string may have one too, but near lock-up it depends \
             on the mesh: compare several",
            text::force(*residual_N)
        ),
        _ if check.kind == CheckKind::LockUp => {
            let above = check.md_m.map(|md_m| format!(" from above {}", text::depth(md_m)));
            format!(
                "Locks up: the friction of the buckled string absorbs any push{}, and none of it \
                 reaches the bit",
                above.unwrap_or_default()
            )
        }
        NoAnswer::Soft(error) => format!("Not solved: {error}"),
        NoAnswer::Stiff(error) => format!("Not solved: {error}"),
    }
}
