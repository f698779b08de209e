//! Verification of the well: the path's two curves, its landmarks and the hole.

mod high_side;
mod hole;
mod input;
mod landmarks;
mod minimum_curvature;
mod spline;
mod spline_accuracy;
mod surveys;
