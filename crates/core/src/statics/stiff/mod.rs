//! The stiff string: static equilibrium of the whole string in its hole, bending stiffness and
//! clearance counted, contact found.

mod active_set;
mod at_rest;
mod barrier;
mod bending;
mod blocks;
mod contact;
mod equations;
mod equilibrium;
mod error;
mod heading;
mod interior_point;
mod profile;
mod settings;
mod solve;
mod state;
mod string_in_hole;
mod wall;

pub(crate) use at_rest::{AtRest, NodeAtRest, at_rest};
pub use equilibrium::Convergence;
pub use error::StiffError;
pub use profile::StiffProfile;
pub use settings::{End, StiffSettings};
pub use solve::solve;
