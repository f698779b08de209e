//! How many neighbours are worked on at once.

/// Elements and nodes are handled by eights: one 512-bit register of `f64`. The arithmetic is written for
/// one of them, over plain arrays of this length, and the compiler widens the loop.
pub const LANES: usize = 8;
