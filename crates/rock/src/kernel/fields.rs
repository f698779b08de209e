//! The state of a block as its kernel sees it.

use serde::{Deserialize, Serialize};

use wholestring_numbers::simd::number::Number;

use crate::grid::GROUP;

/// Pointers to the state of a block.
#[derive(Debug, Clone, Copy)]
pub struct Fields {
    /// Displacement, m, velocity, m/s, one over mass, 1/kg, of the nodes.
    pub displacement: [*mut f64; 3],
    pub velocity: [*mut f64; 3],
    pub inverse_mass: *const f64,
    /// Stress, Pa, and intact part of the elements; a removed element has a negative intact part.
    pub stress: [*mut f64; 6],
    pub intact: *mut f64,
    /// Elements left in each group.
    pub left: *const u8,
    /// Books of the rows of elements.
    pub books: *mut RowBook,
}

// SAFETY: each slab reads and writes its own elements, books and inner layers of nodes, and reads
// the layers of nodes that it shares with its neighbours, which nothing writes meanwhile.
unsafe impl Send for Fields {}
// SAFETY: as above.
unsafe impl Sync for Fields {}

/// Books of a row of elements.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct RowBook {
    /// Energy that plastic flow and viscosity have taken, J.
    pub plastic_J: f64,
    pub viscous_J: f64,
    /// The smallest intact part after the last step.
    pub min_intact: f64,
}

/// First lanes of the registers of a group.
#[inline(always)]
pub fn lanes<N: Number>() -> impl Iterator<Item = usize> {
    (0..GROUP).step_by(N::WIDTH)
}
