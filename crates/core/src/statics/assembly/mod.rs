//! Static analysis of the bottom-hole assembly: what it does to the bit, where it touches, how it
//! bends, and by how much its survey sensor is off the hole's axis.
//!
//! The lower end of the [stiff string](crate::statics::stiff) in fine elements. Theory:
//! `docs/src/theory/stiff-string.md`.

mod axis;
mod contact;
mod extent;
mod hole;
mod sag;
mod settings;
mod solve;
mod zero;

pub use axis::{AssemblyNode, Largest};
pub use contact::{Contact, Touching};
pub use hole::in_straight_hole;
pub use sag::Sag;
pub use settings::{AssemblySettings, Extent};
pub use solve::{Assembly, AssemblyErrors, solve, solve_once};
pub use zero::zeros;
