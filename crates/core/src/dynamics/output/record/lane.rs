//! A number for each lane of a block.

use crate::simd::lanes::DOUBLES;

/// One number for each lane.
pub type Lane = [f64; DOUBLES];
