//! Static analysis of the bottom-hole assembly: the loads of the bit, the contacts, the bending,
//! and the misalignment of the survey sensor with the hole's axis.
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
