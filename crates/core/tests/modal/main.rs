//! Small motions about the string at rest, against closed forms and independent solutions.

#[path = "../common/mod.rs"]
mod common;

mod beams;
mod collars;
mod lines;
mod response;

use wholestring::{
    dynamics::{ContactLaw, DynamicsSettings},
    modal::SmallMotions,
    prelude::*,
    sizing::ElementLength,
    statics::stiff::{End, StiffSettings},
};

/// A wall that a force of a tonne presses in by a micrometre.
const RIGID: ContactLaw = ContactLaw::Linear { stiffness_N_per_m: 1e10, damping_ratio: 0.0 };

/// Elements of a length, a rigid wall, ends on the hole's axis, free to tilt.
fn pinned(element_length_m: f64) -> StiffSettings {
    StiffSettings {
        element_length: ElementLength::Uniform(element_length_m),
        contact_law: RIGID,
        bit_lateral_stiffness_N_per_m: 1e10,
        top: End::Pinned,
        ..StiffSettings::default()
    }
}

/// Small motions about the string of an operation at rest.
#[track_caller]
fn motions(model: &Model, operation: &Operation, settings: &StiffSettings) -> SmallMotions {
    let found = SmallMotions::new(model, operation, settings, &DynamicsSettings::default());
    let found = found.expect("a string at rest");
    assert!(found.is_stable());
    found
}
