//! A case reduced to fewer operations, and to static models, without its text.

use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::{case::Case, settings::narrow};

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
