//! Mesh sizing: lengths of the elements along the string, and the reasons for them.
//!
//! Theory, and the convergence study that the rule comes from: `docs/src/theory/mesh.md`.

mod element_length;
mod intervals;
mod reason;
mod rule;

pub use element_length::{Accuracy, ElementLength};
pub use intervals::{SizedInterval, Sizing};
pub use reason::SizeReason;
pub use rule::assembly_top_m;
