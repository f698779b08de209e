//! Small motions about the string at rest: natural frequencies and shapes, critical speeds, the
//! answer to a force that goes with the rotation.
//!
//! The string at rest is the [stiff string](wholestring::statics::stiff)'s, the inertia the
//! [dynamics](wholestring::dynamics)'. Theory: `docs/src/theory/modes.md`.

mod assembly;
mod campbell;
mod chain;
mod error;
mod factors;
mod family;
mod krylov;
mod line;
mod mode;
mod motions;
mod place;
mod pull;
mod response;
mod search;
mod whirl;

pub use assembly::{Assembly, assembly_length_m};
pub use campbell::{Branch, Campbell, Critical};
pub use error::ModalError;
pub use family::Family;
pub use mode::{Mode, Whirl};
pub use motions::SmallMotions;
pub use place::Place;
pub use response::{Answer, Forcing};
