//! What makes two cases the same: all that their solutions depend on.

use serde::Serialize;
use serde_json::Value as Json;
use wholestring::{
    dynamics::DynamicsSettings, model::Model, operation::Operation, outcome::ModelKind,
    statics::soft::SoftSettings,
};

use crate::{bit_test::BitTest, case::Case, records::Records};

/// What the solvers are given and what is kept of their answers, as they have it themselves: what
/// is added there is part of it.
#[derive(Serialize)]
struct Identity<'a> {
    model: &'a [ModelKind],
    operations: &'a [Operation],
    well_string_mud_rig: &'a Model,
    soft: &'a SoftSettings,
    dynamics: &'a DynamicsSettings,
    tunes_hook_load: bool,
    records: &'a Records,
    bit_test: Option<&'a BitTest>,
}

impl Case {
    /// All that its solutions depend on, down to the last digit. Two cases with the same identity
    /// have the same solutions; name, units and what else is only shown, and the time between
    /// checkpoints, are no part of it.
    ///
    /// JSON has no infinity: a limit that there is none of is `null`.
    pub fn identity(&self) -> Json {
        // Every field is named: a new one either belongs to it or is left out for a reason.
        let Self {
            models,
            model,
            operations,
            bit_test,
            soft,
            dynamics,
            tunes_hook_load,
            records,
            // What is shown.
            name: _,
            units: _,
            survey_notes: _,
            mud_notes: _,
            warnings: _,
            // What does not change the answer.
            checkpoint_interval_s: _,
            // The model holds it, cut to the depth of the bit.
            string: _,
            // What is asked of the string at rest, and at other depths.
            modes: _,
            plan: _,
            // What is reported of the others.
            settings: _,
        } = self;
        let identity = Identity {
            model: models,
            operations,
            well_string_mud_rig: model,
            soft,
            dynamics,
            tunes_hook_load: *tunes_hook_load,
            records,
            bit_test: bit_test.as_ref(),
        };
        serde_json::to_value(identity).expect("numbers, words and lists")
    }
}
