//! Buckling of a pipe in its hole: critical loads by place, and push through a buckled string.
//!
//! With `F` the compression (minus the effective tension), `r` the radial clearance, `w` the buoyed
//! weight per length, `θ` the inclination, `θ'` the build rate and `φ'` the rate of the azimuth, a
//! pipe that is pressed against the wall by
//!
#![doc = include_str!("../../../equations/pressing-load.html")]
//!
//! buckles where
//!
#![doc = include_str!("../../../equations/buckling.html")]
//!
//! (He and Kyllingstad 1995), and never below Lubinski's and Wu and Juvkam-Wold's loads of a
//! vertical hole. A [`Criterion`] selects the author of the loads. Theory and sources:
//! `docs/src/findings.md`.

mod critical;
mod loads;
mod place;
mod push;

pub use loads::{BucklingLoads, Criterion, Shape};
pub use place::{Pipe, Place};
pub use push::{Pushed, Segment, push_through, segments, weight_at_bit_N};
