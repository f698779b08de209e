//! A lamp of the driller's seat.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_judge::{Severity, Wording};
use wholestring_units::UnitSet;

use crate::words;

/// A lamp of the driller's seat.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct Lamp {
    /// Its name.
    pub name: &'static str,
    /// Its severity; null where nothing is measured.
    #[schema(value_type = Option<words::Severity>)]
    pub severity: Option<&'static str>,
    /// Its value in a word or a percentage.
    pub value: String,
    /// Its meaning as a sentence in the viewer's units.
    pub sentence: String,
    #[serde(skip)]
    wording: Wording,
}

impl Lamp {
    pub(super) fn new(
        name: &'static str,
        severity: Option<Severity>,
        value: String,
        text: String,
    ) -> Self {
        let wording = Wording::from(text);
        let sentence = wording.in_units(UnitSet::Si);
        Self { name, severity: severity.map(Severity::name), value, sentence, wording }
    }

    pub(super) fn dark(name: &'static str, text: &str) -> Self {
        Self::new(name, None, "–".to_owned(), text.to_owned())
    }

    /// The same with its sentence in these units.
    pub(super) fn in_units(&self, units: UnitSet) -> Self {
        Self { sentence: self.wording.in_units(units), ..self.clone() }
    }
}
