//! Bottom of the hole as left by a bit.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::Drilling;
use crate::{bit_face::BottomHole, block::Block};

/// Cells of the pattern per element, across.
const FINER: f64 = 2.0;

impl Drilling {
    /// The bottom of the hole as one looks down it: the upmost rock within the bit's radius, a core
    /// left out.
    ///
    /// Radii are those from the bit's reference point, angles those from the x of the block towards
    /// y, depths those below the reference point, the nose: the wall around the bit is above it.
    /// Cells are half an element wide at most.
    pub fn bottom_hole(&self) -> BottomHole {
        let grid = self.block.grid();
        let profile = self.bit.face().profile();
        let (core_m, radius_m) = (profile.core_radius_m(), profile.radius_m());
        let cell_m = grid.size_m[0].min(grid.size_m[1]) / FINER;
        let rings = ((radius_m - core_m) / cell_m).ceil() as usize;
        let sectors = (TAU * radius_m / cell_m).ceil() as usize;
        let mut bottom = BottomHole::new([core_m, radius_m], rings, sectors);
        let tops_m = tops_m(&self.block);
        let nose_m = self.pose.position_m;
        for ring in 0..rings {
            for sector in 0..sectors {
                let (radius_m, angle_rad) = (bottom.radius_m(ring), bottom.angle_rad(sector));
                let column = |axis: usize, across: f64| {
                    let at = (nose_m[axis] + radius_m * across) / grid.size_m[axis];
                    (at.max(0.0) as usize).min(grid.cells[axis] - 1)
                };
                let (i, j) = (column(0, libm::cos(angle_rad)), column(1, libm::sin(angle_rad)));
                if let Some(top_m) = tops_m[i + j * grid.cells[0]] {
                    bottom.set_m(ring, sector, top_m - nose_m.z);
                }
            }
        }
        bottom
    }
}

/// Depth of the upmost face of each column of elements, m, row by row; none for an empty column. A
/// loose element, which has moved from its original place by more than its height, is not part of
/// the bottom.
fn tops_m(block: &Block) -> Vec<Option<f64>> {
    let grid = block.grid();
    let [nx, ny, nz] = grid.cells;
    let top = |i: usize, j: usize| {
        (0..nz).find_map(|k| {
            block.intact([i, j, k])?;
            let [a, b, c, d, ..] = grid.corners([i, j, k]);
            let upper = [a, b, c, d];
            let moved = upper.map(|n| Vector3::from(block.displacement_m(n)));
            let depth_m: f64 = upper.iter().map(|&n| block.position_m(n)[2]).sum();
            let loose = moved.iter().sum::<Vector3<f64>>().norm() > 4.0 * grid.size_m[2];
            (!loose).then_some(depth_m / 4.0)
        })
    };
    let rows = (0..ny).flat_map(|j| (0..nx).map(move |i| (i, j)));
    rows.map(|(i, j)| top(i, j)).collect()
}
