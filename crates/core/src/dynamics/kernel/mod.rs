//! The inner loop: the chain of nodes and elements as it lies in memory, and a step of it.

pub mod border;
pub mod chain;
pub mod half_step;
pub mod lane_layout;
pub mod layout;
pub mod places;
pub mod step;
