//! The stiff string: static equilibrium of the whole string in its hole, with bending stiffness,
//! clearance and contact.

mod active_set;
mod at_rest;
mod axis;
mod bending;
mod blocks;
mod carry;
mod cascade;
mod contact;
mod director;
mod equations;
mod equilibrium;
mod error;
mod interior_point;
mod judge;
mod mesh_error;
mod profile;
mod refine;
mod relaxation;
mod snake;
mod solve;
mod state;
mod string_in_hole;
mod wall;

pub use at_rest::{AtRest, ElementAtRest, NodeAtRest, at_rest};
pub use axis::StringAxis;
pub use equilibrium::{Convergence, Equilibrium, FinerHelix};
pub use error::{StiffError, StiffSettings};
pub use mesh_error::MeshError;
pub use profile::{EquilibriumSummary, StiffProfile};
pub(crate) use solve::solve_on;
pub use solve::{equilibrium, equilibrium_beside, equilibrium_near, solve};
