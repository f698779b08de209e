//! The inner loop: the chain of nodes and elements as it lies in memory, and a step of it.

pub mod chain;
pub mod half_step;
pub mod layout;
pub mod step;
