//! Small motions about the string at rest, against closed forms and independent solutions.

#[path = "../common/mod.rs"]
mod common;

mod beams;
mod collars;
mod lines;
mod response;

use wholestring::{
    dynamics::{ContactLaw, DynamicsSettings},
    ends::TopEnd,
    modal::SmallMotions,
    prelude::*,
    sizing::ElementLength,
    statics::stiff::StiffSettings,
};

/// A wall that a force of a tonne presses in by a micrometre.
const RIGID: ContactLaw = ContactLaw::Linear { stiffness_N_per_m: 1e10, damping_ratio: 0.0 };

/// Elements of a length, a rigid wall, the bit on the hole's axis.
fn rigid(element_length_m: f64) -> StiffSettings {
    StiffSettings {
        element_length: ElementLength::Uniform(element_length_m),
        contact_law: RIGID,
        bit_lateral_stiffness_N_per_m: 1e10,
        ..StiffSettings::default()
    }
}

/// Small motions about the string of an operation at rest, its top free to tilt.
#[track_caller]
fn motions(model: &Model, operation: &Operation, settings: &StiffSettings) -> SmallMotions {
    let mut model = model.clone();
    model.ends.top = TopEnd::Pinned;
    let found = SmallMotions::new(&model, operation, settings, &DynamicsSettings::default());
    let found = found.expect("a string at rest");
    assert!(found.is_stable());
    found
}
