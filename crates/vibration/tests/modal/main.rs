//! Small motions about the string at rest, against closed forms and independent solutions.

#[path = "../../../core/tests/common/mod.rs"]
mod common;

mod beams;
mod bent;
mod collars;
mod lines;
mod response;

use common::rigid::rigid;
use wholestring::{
    dynamics::DynamicsSettings, ends::TopEnd, prelude::*, statics::stiff::StiffSettings,
};
use wholestring_vibration::modal::SmallMotions;

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
