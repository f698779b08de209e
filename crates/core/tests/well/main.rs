//! Verification of the well: the path's two curves, its landmarks and the hole.

#[path = "../common/mod.rs"]
mod common;

mod high_side;
mod hole;
mod input;
mod landmarks;
mod minimum_curvature;
mod roughness;
mod spline;
mod spline_accuracy;
mod surveys;
