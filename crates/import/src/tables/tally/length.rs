//! The length of a component.

use wholestring_units::Unit;

use crate::fragment::Origin;

/// Length of a component.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Length {
    /// It fills the rest of the string.
    ToSurface,
    /// A given length.
    Of { number: f64, unit: &'static Unit, origin: Origin, joints: Option<f64> },
}

impl Length {
    pub(crate) fn si_m(&self) -> Option<f64> {
        match self {
            Length::ToSurface => None,
            Length::Of { number, unit, .. } => Some(unit.to_si(*number)),
        }
    }
}
