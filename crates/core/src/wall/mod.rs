//! The wall of the hole: where it is, how it pushes back and how it rubs, one law for every solver.

mod bore;
pub mod contact;
pub mod friction;

pub use bore::{Bore, BorePoint};
