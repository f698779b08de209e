//! The inner loop: the chain of nodes and elements in its memory layout, and a step of it.

pub mod border;
pub mod chain;
pub mod half_step;
pub mod lane_layout;
pub mod layout;
pub mod places;
pub mod step;
