//! The drill string: components from the bit up.

pub mod catalogue;
mod component;
mod drill_string;
mod spec;

pub use component::{Blades, Component, Material, ToolJoints};
pub use drill_string::{DrillString, Span};
pub use spec::{AssemblyError, ComponentLength, ComponentSpec, StringSpec};
