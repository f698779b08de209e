//! Operations in words, their colours, and numbers in a few digits.

use wholestring::operation::OperationKind;

/// An operation in words, the same on every front: its name with spaces.
pub fn operation_name(name: &str) -> String {
    name.replace('_', " ")
}

/// Place of an operation among the colours of curves: the same in every picture.
pub fn colour(name: &str) -> usize {
    use OperationKind::{BackReam, Drill, Ream, RotateOffBottom, Slide, TripIn, TripOut};
    match OperationKind::from_name(name) {
        Some(TripIn) => 0,
        Some(TripOut) => 1,
        Some(RotateOffBottom) => 2,
        Some(Drill) => 3,
        Some(Slide) => 4,
        Some(Ream) => 5,
        Some(BackReam) | None => 6,
    }
}

pub(super) fn rotates(name: &str) -> bool {
    OperationKind::from_name(name).is_some_and(OperationKind::rotates)
}

pub(super) fn on_bottom(name: &str) -> bool {
    OperationKind::from_name(name).is_some_and(OperationKind::on_bottom)
}

/// A number in four digits, and at most three decimals.
pub(crate) fn four(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let whole = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    let decimals = (3.0 - whole).clamp(0.0, 3.0) as usize;
    let text = format!("{value:.decimals$}");
    let text = if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        "0".to_owned()
    } else {
        text
    };
    text.replace('-', "\u{2212}")
}
