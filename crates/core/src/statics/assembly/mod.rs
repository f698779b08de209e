//! Static analysis of the bottom-hole assembly: the loads of the bit, the contacts, the bending,
//! and the misalignment of the survey sensor with the hole's axis.
//!
//! The lower end of the [stiff string](crate::statics::stiff) in fine elements. Theory:
//! `docs/src/theory/stiff-string.md`.

mod axis;
mod contact;
mod extent;
mod sag;
mod solve;

pub use axis::{AssemblyNode, Largest};
pub use contact::{Contact, Touching};
pub use extent::{AssemblySettings, Extent};
pub use sag::{Sag, zeros};
pub use solve::{Assembly, AssemblyErrors, in_straight_hole, solve, solve_once};
