//! The drill string: components from the bit up.

mod body;
mod builder;
pub mod catalogue;
mod component;
mod connection;
mod drill_string;
mod free_strain;
mod lower_end;
mod material;
mod nested_casings;
mod spec;
mod strength;

pub use body::{BodyBend, Cavity, Eccentricity, LateralForce, MAX_ECCENTRIC, NEAREST_BEND_M};
pub use component::{Blades, Component, ToolJoints};
pub use connection::{ConnectionStrength, RotaryConnection, Shoulder};
pub use drill_string::{DrillString, Span};
pub use free_strain::{FreeStrain, REFERENCE_TEMPERATURE_K, Surroundings};
pub use material::{Material, STEEL_EXPANSION_PER_K};
pub use nested_casings::nested_casings;
pub use spec::{AssemblyError, ComponentLength, ComponentSpec, StringSpec};
pub use strength::BodySection;
