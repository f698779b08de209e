//! Mesh sizing: how long the elements are to be along the string, and what asked for that.
//!
//! Theory, and the convergence study that the rule comes from: `docs/src/theory/mesh.md`.

mod element_length;
mod intervals;
mod reason;
mod rule;

pub use element_length::{Accuracy, ElementLength};
pub use intervals::{SizedInterval, Sizing};
pub use reason::SizeReason;
pub(crate) use rule::assembly_top_m;
