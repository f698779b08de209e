//! Count of numbers processed side by side: two 512-bit registers of them.

/// So many doubles.
pub const DOUBLES: usize = 16;

/// So many singles.
pub const SINGLES: usize = 2 * DOUBLES;
