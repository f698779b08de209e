//! Capacity of pipe: the stresses in a body, and the strengths of API RP 7G and API TR 5C3.
//!
//! A [`Body`] is the tube of a component; a [`Tube`] has the dimensions that burst and collapse
//! need, for drill pipe and casing alike. Theory and sources: `docs/src/theory/strength.md`.

mod body;
mod stress;
mod tube;

pub use body::{ALLOWED_PART_OF_YIELD, Body, margin_of_overpull_N};
pub use stress::{BendSide, BodyLoads, Surface, SurfaceStress, surface_stresses, worst_stress};
pub use tube::{Collapse, CollapseRegime, MILL_TOLERANCE, Tube};

/// A pound-force per square inch, Pa.
pub const PSI_PA: f64 = 6_894.757_293_168_361;
