//! The limits of an operation: what each component and the rig bear, and how near it is to that.
//!
//! [`limits`] compares the loads of a solved operation with what is known of strength and rig. What is not
//! known is [told](Unchecked), what carries no load is left out. Theory and sources of the
//! [factors](DesignFactors): `docs/src/theory/strength.md`.

mod along;
mod kind;
mod limit;
mod loads;
mod lock_up;
mod overpull;
mod rig;
mod settings;
mod strengths;
mod surface;

pub use kind::{DesignFactors, LimitKind};
pub use limit::{Limits, LoadCheck, Missing, Standing, Unchecked};
pub use settings::LimitSettings;
pub use surface::{SurfaceLimit, surface_limits};

use wholestring::{
    model::Model, operation::Operation, outcome::Solution, statics::soft::SoftLoads,
};

/// The limits of a solved operation: of each kind one for each component that it concerns, at the place
/// where it is nearest to its limit, and one for the rig.
pub fn limits(
    model: &Model,
    operation: &Operation,
    solution: &Solution<'_>,
    settings: &LimitSettings,
) -> Limits {
    of_loads(model, operation, &loads::Loads::of(model, operation, solution), settings)
}

/// The same of a soft string of which nothing but its loads is known.
pub fn limits_of_soft(
    model: &Model,
    operation: &Operation,
    loads: &SoftLoads,
    settings: &LimitSettings,
) -> Limits {
    of_loads(model, operation, &loads::Loads::of_soft(model, operation, loads), settings)
}

fn of_loads(
    model: &Model,
    operation: &Operation,
    loads: &loads::Loads<'_>,
    settings: &LimitSettings,
) -> Limits {
    let mut found = Limits::default();
    let strengths = strengths::Strengths::of(model, &mut found);
    along::limits(&strengths, loads, settings, &mut found);
    overpull::limits(model, operation, &strengths, loads, settings, &mut found);
    rig::limits(model, loads, settings, &mut found);
    lock_up::limit(model, operation, loads, settings, &mut found);
    found
}
