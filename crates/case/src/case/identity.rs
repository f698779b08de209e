//! The identity of a case: all inputs that its solutions depend on.

use serde::Serialize;
use serde_json::Value as Json;
use wholestring::{
    dynamics::DynamicsSettings,
    model::Model,
    operation::{Operation, OperationKind},
    outcome::ModelKind,
    statics::soft::SoftSettings,
};

use crate::{bit_test::BitTest, case::Case, dynamics::records::Records, settings::narrow};

/// All inputs of the solvers and settings of recorded results, serialised as the engine's own
/// types, so that a new field becomes a part of the identity.
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
    /// Returns all inputs that its solutions depend on, to the last digit. Two cases with the same
    /// identity have the same solutions. Name, units and other display settings, and the time
    /// between checkpoints, are not included.
    ///
    /// JSON has no infinity: a missing limit is `null`.
    pub fn identity(&self) -> Json {
        // Every field is named, so that a new one must be either included or left out for a reason.
        let Self {
            models,
            model,
            operations,
            bit_test,
            soft,
            dynamics,
            tunes_hook_load,
            records,
            // Display only.
            name: _,
            units: _,
            survey_notes: _,
            hole_notes: _,
            mud_notes: _,
            warnings: _,
            // No effect on the results.
            checkpoint_interval_s: _,
            // Part of the model, cut to the depth of the bit.
            string: _,
            // Evaluated on the static string, and at other depths.
            modes: _,
            plan: _,
            // Derived from the other fields.
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

// A case reduced to fewer operations, and to static models, without its text.

impl Case {
    /// Returns the case for these models, and for one operation where it is named. It equals the
    /// case read from its text with `model` and `operation.kind` set to them, except for plan,
    /// modes and warnings, which remain those of the whole.
    ///
    /// Returns `None` where the text is needed: for dynamics, which need more than statics do; for
    /// an operation that the case does not have; for a schedule and a bit test, which follow from
    /// all operations; for no model, or one that is named twice.
    #[must_use]
    pub fn narrowed(&self, models: &[ModelKind], only: Option<OperationKind>) -> Option<Self> {
        let named_twice = models.iter().enumerate().any(|(at, model)| models[..at].contains(model));
        let is_open = models.is_empty() || named_twice || ModelKind::any_in_time(models);
        if is_open || self.bit_test.is_some() || !self.dynamics.schedule.is_empty() {
            return None;
        }
        let is_wanted = |kind| only.is_none_or(|only| only == kind);
        let operations: Vec<_> =
            self.operations.iter().filter(|operation| is_wanted(operation.kind)).copied().collect();
        if operations.is_empty() {
            return None;
        }
        let mut settings = self.settings.clone();
        narrow(&mut settings, models, &operations, &self.dynamics);
        Some(Self { models: models.to_vec(), operations, settings, ..self.clone() })
    }
}
