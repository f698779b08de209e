//! The wall of the hole: where it is, how it pushes back and how it rubs, one law for every solver.
//!
//! What a step makes of the laws is the step's own; see `docs/src/theory/wall.md` and
//! `friction.md`.

mod bore;
pub mod contact;
pub(crate) mod friction;
pub(crate) mod normal_force;

pub use bore::{Bore, BorePoint};
