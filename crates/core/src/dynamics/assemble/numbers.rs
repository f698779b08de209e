//! Numbers that a run can use.

use super::error::SetupError;

/// Refuses numbers, each with its name: those that must be positive, and those that may be zero.
pub(in crate::dynamics) fn check_numbers(
    positive: &[(&'static str, f64)],
    not_negative: &[(&'static str, f64)],
) -> Result<(), SetupError> {
    let wrong = |value: f64, enough: bool| !(value.is_finite() && enough);
    for &(name, value) in positive {
        if wrong(value, value > 0.0) {
            return Err(SetupError::Setting { name, value, expected: "a positive number" });
        }
    }
    for &(name, value) in not_negative {
        if wrong(value, value >= 0.0) {
            return Err(SetupError::Setting { name, value, expected: "zero or a positive number" });
        }
    }
    Ok(())
}
