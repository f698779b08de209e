//! The rod: the drill string as a chain of two-node beam elements.
//!
//! One element serves every solver. Its forces come from one energy ([`element`]), written once over
//! a [`number::Number`]: an `f64`, or as many numbers as the processor's registers hold ([`wide`]).

pub mod bent;
pub mod counted;
pub mod element;
pub mod lanes;
pub mod mesh;
pub mod number;
pub mod peak;
pub mod section;
pub mod stability;
pub mod torsion;
pub mod vector;
pub mod wide;
