//! The soft string: a string without bending stiffness that lies on the wall everywhere.
//!
//! With `s` the measured depth, `t` the hole's tangent (towards the bit), `κ n` its curvature
//! vector, `F` the effective tension, `w` the buoyed weight per length and `k` the downward
//! vertical, the load that presses the pipe against the wall is
//!
//! ```text
//! q = F κ n + w (k − (k·t) t),      N = |q|.
//! ```
//!
//! It holds both planes, so a turn loads the wall as a build does. The pipe touches the wall in the
//! direction of `q`: on the high side in a build under tension, on the low side in a tangent.
//! Friction opposes the sliding velocity of the touching surface, `v` along the hole (positive
//! towards the bit) and `Ω r` around it, `r` the contact radius; with `V = hypot(v, Ω r)`
//!
//! ```text
//! dF/ds = −w (k·t) + μ N v/V,      dM/ds = −μ' N r (Ω r)/V
//! ```
//!
//! with `μ` the coefficient along the hole and `μ'` the one around it, the same unless the hole
//! says otherwise: friction lies on an ellipse, as in the dynamics. from `F = −WOB` and `M = M_bit`
//! at the bit. Drilling at 70 rev/min and 10 m/h therefore keeps a drag of 0.5 % of `μ N`. Without
//! rotation `V` drops out: a tripping or sliding string drags with all of `μ N`, however slow; its
//! torque is the motor's, carried unchanged to the surface.
//!
//! Stretch and twist follow from Hooke's law on the body's section `A`, with the mud's pressure `p`
//! inside and outside:
//!
//! ```text
//! du/ds = F/(EA) − (1 − 2ν) p/E,      dφ/ds = M/(GJ),      p = ρ_mud g (depth below the surface).
//! ```
//!
//! The real tension is `F − p A`; the hoop and radial stresses `−p` give the `2ν`. The reference is
//! the unloaded string, in air and untwisted. Buckling is not counted: a string in compression
//! beyond its buckling load drags more than this model says.
//!
//! A mud with a rheology drags besides ([`crate::mud::annulus`]): `dF/ds` gains the pull of the mud
//! and `dM/ds` its torque at the operation's speeds and flow rate, the bit's jets lift with their
//! thrust, and `p` becomes two pressures, with the losses of the annulus outside and those of
//! annulus, bit and bore inside.
//!
//! What it bears follows: the metal's true force and von Mises stress from tension, torque,
//! pressures and bending ([`crate::string::BodySection`]); bending from the hole's curvature and,
//! where tool joints hold the body off the wall, from what the span between them adds
//! ([`crate::statics::span`]), the larger of that at the joints and half-way; the power of
//! friction, force times sliding speed, `μ N V`.
//!
//! The model was introduced by Johancsik, Friesen and Dawson, *Torque and Drag in Directional
//! Wells: Prediction and Measurement*, Journal of Petroleum Technology 36 (1984); the effective
//! tension and the vector form are standard.

mod bearing;
mod circulation;
mod error;
mod integrate;
mod load;
mod motion;
mod profile;
mod settings;

use crate::{model::Model, operation::Operation};

pub use error::SoftError;
use motion::Sliding;
pub use profile::SoftProfile;
pub use settings::SoftSettings;

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
