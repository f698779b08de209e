//! The drill string: components from the bit up.

mod component;
mod drill_string;

pub use component::{Component, Material, ToolJoints};
pub use drill_string::DrillString;
