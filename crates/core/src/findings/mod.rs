//! What an engineer must know about a result.
//!
//! Every rule is a pure function from the model, the operation and what a solver gave to
//! [`Finding`]s: a kind, how grave it is, where, how much, and what that is compared with. Words
//! and users' units are not made here.

mod buckling;
mod finding;
mod hook_load;
mod interval;
mod kind;
mod lateral_force;
mod lock_up;
mod motion;
mod numerics;
mod rig;
mod steadiness;
mod strength;
mod weight_on_bit;
mod window;

pub use finding::{Finding, Level};
pub use kind::Kind;
pub use strength::YIELD_USE_WARNING;

use crate::{
    dynamics::{DynamicOutcome, DynamicsSettings},
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    outcome::{Profile, Scalars},
    statics::{
        soft::SoftProfile,
        stiff::{StiffError, StiffProfile},
    },
};

use window::Window;

/// What is to be reported of an operation as the soft string solved it, the gravest first.
pub fn of_soft(model: &Model, operation: &Operation, profile: &SoftProfile) -> Vec<Finding> {
    let line = buckling::Line::of(model, operation, &profile.profile);
    let mut found = at_rest(model, operation, &profile.scalars, &profile.profile, &line);
    found.extend(lateral_force::left_out(model));
    found.extend(pump_at_rest(model, profile.hydraulics.as_ref()));
    gravest_first(found)
}

/// What is to be reported of an operation as the stiff string solved it, the gravest first.
pub fn of_stiff(model: &Model, operation: &Operation, profile: &StiffProfile) -> Vec<Finding> {
    let line = buckling::Line::of(model, operation, &profile.profile);
    let mut found = at_rest(model, operation, &profile.scalars, &profile.profile, &line);
    found.extend(numerics::equilibrium(&profile.convergence));
    found.extend(numerics::element_buckles(profile.convergence.buckled_element.as_ref()));
    found.extend(numerics::penetration_at_rest(model, profile.deepest_penetration_m));
    found.extend(pump_at_rest(model, profile.hydraulics.as_ref()));
    gravest_first(found)
}

/// What is to be reported of the pump's pressure, where the mud has a rheology.
fn pump_at_rest(model: &Model, hydraulics: Option<&Hydraulics>) -> Option<Finding> {
    rig::pump(&model.rig, [hydraulics?.pump_pressure_Pa; 2])
}

/// What is to be reported of an operation for which the stiff string has no answer.
pub fn of_no_equilibrium(error: &StiffError) -> Vec<Finding> {
    numerics::no_equilibrium(error).into_iter().collect()
}

/// What is to be reported of a state of equilibrium.
fn at_rest(
    model: &Model,
    operation: &Operation,
    scalars: &Scalars,
    profile: &Profile,
    line: &buckling::Line<'_>,
) -> Vec<Finding> {
    let mut found = Vec::new();
    found.extend(hook_load::steady(model, scalars.hook_load_N));
    found.extend(lock_up::at_rest(model, operation, scalars.hook_load_N, &profile.md_m, line));
    found.extend(buckling::findings(line));
    found.extend(rig::hoist(&model.rig, [scalars.hook_load_N; 2]));
    let torque_N_m = scalars.surface_torque_N_m.abs();
    found.extend(rig::top_drive(&model.rig, [torque_N_m; 2]));
    found.extend(strength::yield_use(&profile.md_m, &profile.yield_use));
    found
}

/// What is to be reported of an operation as the dynamics solved it to its end, the gravest first.
pub fn of_dynamic(
    model: &Model,
    operation: &Operation,
    settings: &DynamicsSettings,
    outcome: &DynamicOutcome,
) -> Vec<Finding> {
    let Some(window) = Window::of(outcome) else {
        return Vec::new();
    };
    let line = buckling::Line::of(model, operation, &outcome.nodes);
    let mut found = Vec::new();
    found.extend(hook_load::varying(model, &window));
    found.extend(lock_up::of_dynamic(model, operation, &window));
    found.extend(weight_on_bit::findings(operation, settings, &window));
    found.extend(buckling::findings(&line));
    found.extend(rig::hoist(&model.rig, window.mean_and_max("hook_load_N")));
    found.extend(rig::top_drive(&model.rig, window.torque_N_m()));
    found.extend(window.pump_pressure_Pa().and_then(|of| rig::pump(&model.rig, of)));
    found.extend(strength::yield_use(&outcome.nodes.md_m, &outcome.nodes.yield_use));
    found.extend(motion::findings(settings, outcome, &window));
    found.extend(numerics::findings(model, outcome));
    found.extend(steadiness::findings(operation, outcome));
    gravest_first(found)
}

/// Among equals the order in which they were found: what stops the operation, then why.
fn gravest_first(mut found: Vec<Finding>) -> Vec<Finding> {
    found.sort_by_key(|of| std::cmp::Reverse(of.level));
    found
}
