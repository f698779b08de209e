//! Layers of elements that are worked on together.

use super::{
    fields::Fields,
    nodes::{drift, kick},
    row,
};
use crate::{constants::Constants, grid::Grid};
use wholestring_numbers::simd::number::Number;

/// Layers of elements that are processed together, and memory for their forces on the nodes.
#[derive(Debug, Clone)]
pub struct Slab {
    /// First layer of elements, and the first one below.
    pub from: usize,
    pub to: usize,
    /// Whether the block ends with it: the last layer of nodes is its own.
    pub closes: bool,
    /// Pulls on a layer of nodes, N: on the first one, and in turn on those that follow.
    pulls: [[Vec<f64>; 3]; 3],
    row: row::Pulls,
}

impl Slab {
    /// From a layer of elements to another.
    pub fn new(grid: &Grid, from: usize, to: usize) -> Self {
        let layer = || [0, 1, 2].map(|_| vec![0.0; grid.node_layer()]);
        Self {
            from,
            to,
            closes: to == grid.cells[2],
            pulls: [layer(), layer(), layer()],
            row: row::Pulls::new(grid),
        }
    }

    /// Which of `pulls` is a layer's.
    fn buffer(&self, layer: usize) -> usize {
        match layer - self.from {
            0 => 0,
            below => 1 + below % 2,
        }
    }

    /// Pulls on its first layer of nodes.
    pub fn first(&self) -> &[Vec<f64>; 3] {
        &self.pulls[0]
    }

    /// Pulls on its last layer of nodes.
    pub fn last(&self) -> &[Vec<f64>; 3] {
        &self.pulls[self.buffer(self.to)]
    }
}

/// The elements of a slab answer, and the nodes between them move.
///
/// # Safety
/// `fields` point to the state of a block of this grid, and nothing else uses this slab's part of
/// it.
#[inline(always)]
pub unsafe fn work<N: Number<Real = f64>>(
    fields: &Fields,
    grid: &Grid,
    constants: &Constants,
    slab: &mut Slab,
) {
    let dt = constants.dt_s;
    for axis in &mut slab.pulls[0] {
        axis.fill(0.0);
    }
    for layer in slab.from..slab.to {
        let (here, below) = (slab.buffer(layer), slab.buffer(layer + 1));
        // The layers shared with the slabs above and below drift and are kicked outside.
        let own = |layer: usize| layer > slab.from && (layer < slab.to || slab.closes);
        for axis in &mut slab.pulls[below] {
            axis.fill(0.0);
        }
        // SAFETY: the caller's; layers between the first and the last are this slab's alone.
        unsafe {
            if own(layer + 1) {
                drift::<N>(fields, grid, dt, layer + 1);
            }
            for j in 0..grid.element_rows() {
                if row::work::<N>(fields, grid, constants, [j, layer], &mut slab.row) {
                    slab.row.hand_on::<N>(grid, j, 0, &mut slab.pulls[here]);
                    slab.row.hand_on::<N>(grid, j, 1, &mut slab.pulls[below]);
                }
            }
            if own(layer) {
                kick::<N>(fields, grid, dt, layer, &slab.pulls[here], None);
            }
            if own(layer + 1) && layer + 1 == slab.to {
                kick::<N>(fields, grid, dt, layer + 1, &slab.pulls[below], None);
            }
        }
    }
}
