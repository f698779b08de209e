//! The rod: the drill string as a chain of two-node beam elements.
//!
//! One element serves every solver. Its forces come from one energy ([`element`]), written once
//! over a [`number::Number`]: an `f64`, or as many numbers as the processor's registers hold. Those
//! are not to be had from outside: their operators are safe to write, and sound only where the
//! processor was found to have the registers.
//!
//! ```compile_fail
//! use wholestring::rod::wide;
//! ```
//!
//! ```compile_fail
//! type Register = <f64 as wholestring::rod::number::Real>::Xmm;
//! ```

pub(crate) mod beam_column;
pub mod bent;
pub mod buckled_element;
pub(crate) mod contact_length;
pub mod dual;
pub mod element;
pub(crate) mod imbalance;
pub mod in_fluid;
pub mod mesh;
pub mod regions;
pub mod section;
pub mod stability;
pub(crate) mod tangent;
pub mod torsion;

pub use crate::simd::vector;

/// Number types over which the mechanics of an element is written.
pub mod number {
    pub use crate::simd::number::{Number, Real};
}
