//! The stiff string: static equilibrium of the whole string in its hole, bending stiffness and
//! clearance counted, contact found.

mod active_set;
mod barrier;
mod bending;
mod blocks;
mod contact;
mod equations;
mod error;
mod interior_point;
mod profile;
mod settings;
mod solve;
mod state;
mod string_in_hole;
mod wall;

pub use error::StiffError;
pub use profile::{Convergence, StiffProfile};
pub use settings::{End, StiffSettings};
pub use solve::solve;
