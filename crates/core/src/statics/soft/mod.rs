//! The soft string: a string without bending stiffness that lies on the wall everywhere.
//!
//! With `s` the measured depth, `t` the hole's tangent (towards the bit), `κ n` its curvature
//! vector, `F` the effective tension, `w` the buoyed weight per length, `k` the downward vertical,
//! `r` the contact radius and `V = hypot(v, Ω r)` the sliding speed,
//!
//! ```text
//! q = F κ n + w (k − (k·t) t),      N = |q|
//! dF/ds = −w (k·t) + μ N v/V,       dM/ds = −μ' N r (Ω r)/V
//! ```
//!
//! from `F = P − WOB` and `M = M_bit` at the bit, `P` the pull on it (Johancsik, Friesen and Dawson
//! 1984). The wall load of a helix is counted if asked. Theory: `docs/src/theory/soft-string.md`;
//! of a flowing mud: `docs/src/theory/mud.md`.

mod bearing;
mod error;
mod integrate;
mod load;
mod profile;
mod settings;
mod travel;

use crate::{model::Model, operation::Operation, statics::sliding::Sliding};

pub use error::SoftError;
pub use profile::SoftProfile;
pub use settings::SoftSettings;
pub(crate) use travel::scalars_at;

/// Torque and drag of one operation by the soft string with its default settings.
///
/// # Errors
/// Those of [`solve`].
pub fn soft_string(model: &Model, operation: &Operation) -> Result<SoftProfile, SoftError> {
    solve(model, operation, &SoftSettings::default())
}

/// Torque and drag of one operation by the soft string.
///
/// # Errors
/// A setting or set point out of its range, a string that is not as long as the bit is deep, or a
/// load that leaves the range of floating-point numbers.
pub fn solve(
    model: &Model,
    operation: &Operation,
    settings: &SoftSettings,
) -> Result<SoftProfile, SoftError> {
    error::check(model, operation, settings)?;
    let sliding = Sliding::of(operation);
    let integral = integrate::from_bit(model, operation, sliding, settings)?;
    Ok(SoftProfile::new(model, operation, integral))
}
