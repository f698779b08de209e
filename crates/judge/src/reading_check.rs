//! Checks of readings at the surface, and of results derived from them.

use serde::{Deserialize, Serialize};
use wholestring_units::UnitSet;

use crate::{Check, CheckKind, Severity};

/// A check of readings, or of a result derived from them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReadingCheck {
    /// Lines of the readings in their file; empty where it does not concern single lines.
    pub lines: Vec<String>,
    /// The check; value and limit are SI.
    #[serde(flatten)]
    pub check: Check,
}

impl ReadingCheck {
    /// A check with its sentence, without a full stop, in which quantities are marked
    /// ([`Quantity`](crate::Quantity)); it is in SI units until [`Self::in_units`].
    pub fn new(kind: CheckKind, severity: Severity, sentence: String) -> Self {
        let check = Check::of_readings(kind, severity, [None; 2], sentence);
        Self { lines: Vec::new(), check }
    }

    /// The same with its value and the number that it is compared with, SI.
    #[must_use]
    pub fn numbers(mut self, [value, limit]: [Option<f64>; 2]) -> Self {
        (self.check.value, self.check.limit) = (value, limit);
        self
    }

    /// The same with its sentence in these units.
    #[must_use]
    pub fn in_units(self, units: UnitSet) -> Self {
        Self { check: self.check.in_units(units), ..self }
    }

    /// The same of readings on these lines of their file.
    #[must_use]
    pub fn on(self, lines: Vec<String>) -> Self {
        Self { lines, ..self }
    }
}
