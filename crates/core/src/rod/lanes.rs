//! How many numbers stand side by side.

/// Elements and nodes are handled by rows of so many: one 512-bit register of `f32`, two of `f64`.
pub const LANES: usize = 32;
