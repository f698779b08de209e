//! The wall of the hole: where it is, how it pushes back and how it rubs, one law for every solver.
//!
//! The application of the laws in a step is part of the step; see `docs/src/theory/wall.md` and
//! `friction.md`.

mod bore;
pub mod contact;
pub(crate) mod friction;
pub(crate) mod normal_force;

pub use bore::{Bore, BorePoint};
