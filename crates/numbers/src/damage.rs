//! Validity checks of stored states.

/// Why a stored state is not one of the model that it is resumed with: a length or a place does not
/// fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("it is damaged: {0}")]
pub struct Damaged(pub &'static str);

/// Checks a condition on a stored state. Returns [`Damaged`] with the subject `about` if it does
/// not hold.
pub fn ensure(holds: bool, about: &'static str) -> Result<(), Damaged> {
    holds.then_some(()).ok_or(Damaged(about))
}
