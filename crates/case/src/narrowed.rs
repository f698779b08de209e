//! A case for fewer operations, and solved by statics, without its text.

use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::{case::Case, settings::narrow};

impl Case {
    /// The case for these models, and for one operation where it is named: what its text makes of
    /// it with `model` and `operation.kind` set to them, but for plan, modes and warnings, which
    /// stay those of the whole.
    ///
    /// Nothing where only the text can tell: of dynamics, which need what statics do not; of an
    /// operation that the case does not have; of a schedule and of a bit test, which follow from
    /// all operations; of no model, or one that is named twice.
    #[must_use]
    pub fn narrowed(&self, models: &[ModelKind], only: Option<OperationKind>) -> Option<Self> {
        let named_twice = models.iter().enumerate().any(|(at, of)| models[..at].contains(of));
        let is_open = models.is_empty() || named_twice || ModelKind::any_in_time(models);
        if is_open || self.bit_test.is_some() || !self.dynamics.schedule.is_empty() {
            return None;
        }
        let is_wanted = |kind| only.is_none_or(|only| only == kind);
        let operations: Vec<_> =
            self.operations.iter().filter(|of| is_wanted(of.kind)).copied().collect();
        if operations.is_empty() {
            return None;
        }
        let mut settings = self.settings.clone();
        narrow(&mut settings, models, &operations, &self.dynamics);
        Some(Self { models: models.to_vec(), operations, settings, ..self.clone() })
    }
}
