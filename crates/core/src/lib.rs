//! Mechanics of a whole drill string in a deviated well, from the top drive to the rock.
//!
//! The data flows one way: a [`model::Model`] (well, string, mud, rig) and an
//! [`operation::Operation`] go into a solver ([`statics::soft`], [`dynamics`]), and profiles and
//! scalars come out. Nothing here reads files, prints or starts threads; everything is SI, angles
//! in radians.
//!
//! Axes are north, east and down; measured depth (MD) grows towards the bit; a positive rotation is
//! clockwise looking down the hole.
#![warn(missing_docs)]

#[cfg(test)]
extern crate self as wholestring;

#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;
mod damage;
pub mod dynamics;
pub mod findings;
mod finite;
pub mod model;
pub mod mud;
pub mod operation;
pub mod outcome;
mod random;
pub mod rig;
pub mod rock;
pub mod rod;
mod simd;
pub mod statics;
pub mod string;
pub mod wall;
pub mod well;

pub use damage::Damaged;

/// Standard acceleration of gravity, m/s² (CGPM 1901, exact by definition).
pub const GRAVITY_M_PER_S2: f64 = 9.80665;
