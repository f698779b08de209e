//! What a drilling engineer plans with: the same string at many depths and frictions, what its parts bear,
//! how far the well can go, and what friction was.
//!
//! Everything here is computed from the engine's models ([`wholestring`]), in SI, angles in radians; nothing
//! reads files, prints or starts threads. A [`Setup`] gives the model at any depth of the bit.
#![warn(missing_docs)]

pub mod reach;
mod root;
mod setup;
pub mod uncertainty;

pub use root::root;
pub use setup::{Setup, WallFriction};
