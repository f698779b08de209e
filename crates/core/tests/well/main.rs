//! Verification of the well: the path's two curves, its kick-off and build and the hole.

#[path = "../common/mod.rs"]
mod common;

mod high_side;
mod hole;
mod input;
mod kick_off;
mod minimum_curvature;
mod roughness;
mod spline;
mod spline_accuracy;
mod surveys;
mod tortuosity;
