//! The soft string: a string without bending stiffness that is on the wall everywhere.
//!
//! With `s` the measured depth, `t` the hole's tangent (towards the bit), `κ n` its curvature
//! vector, `F` the effective tension, `w` the buoyed weight per length, `k` the downward vertical,
//! `r` the contact radius and `V = hypot(v, Ω r)` the sliding speed, the wall's load is
//!
#![doc = include_str!("../../../equations/wall-load.html")]
//!
//! and friction along and around the hole, `μ` and `μ'`, makes
//!
#![doc = include_str!("../../../equations/soft-string.html")]
//!
//! from `F = P − WOB` and `M = M_bit` at the bit, `P` the pull on it (Johancsik, Friesen and Dawson
//! 1984). The wall load of a helix is counted on request. Theory: `docs/src/theory/soft-string.md`;
//! of a flowing mud: `docs/src/theory/mud.md`.

mod bearing;
mod error;
mod hole;
mod integrate;
mod load;
mod loads;
mod profile;
mod segment;
mod string;
mod travel;

use crate::{model::Model, operation::Operation};

pub use error::{SoftError, SoftSettings};
pub use loads::SoftLoads;
pub use profile::SoftProfile;
pub use string::SoftString;
pub(crate) use travel::scalars_at;

/// Torque and drag of one operation by the soft string with its default settings.
///
/// # Errors
/// Those of [`solve`].
pub fn soft_string(model: &Model, operation: &Operation) -> Result<SoftProfile, SoftError> {
    solve(model, operation, &SoftSettings::default())
}

/// Torque and drag of one operation by the soft string; of several with the bit at one depth a
/// [`SoftString`] has them in less time.
///
/// # Errors
/// A setting or set point out of its range, a string that is not as long as the bit is deep, or a
/// load that leaves the range of floating-point numbers.
pub fn solve(
    model: &Model,
    operation: &Operation,
    settings: &SoftSettings,
) -> Result<SoftProfile, SoftError> {
    SoftString::new(model, operation.bit_depth_m, settings)?.solve(operation)
}
