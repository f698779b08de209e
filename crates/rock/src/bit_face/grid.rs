//! Lookup of the parts of the face: a square grid across the axis.

use nalgebra::Vector3;

use super::{body::Body, cutter::Cutter, profile::Profile};

/// Cells across the axis, each with the cutters that may reach into it and the lowest point of
/// anything there.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    half_width_m: f64,
    cells_per_m: f64,
    cells: usize,
    /// Index at which each cell's cutters begin; one more than there are cells.
    starts: Vec<u32>,
    cutters: Vec<u16>,
    lowest_m: Vec<f64>,
    /// Lowest point of the body alone.
    body_m: Vec<f64>,
    /// Everything is within this cylinder: squared radius, highest and lowest point, m.
    pub(super) radius2_m2: f64,
    pub(super) z_m: [f64; 2],
}

/// Tolerance for rounding of the body's lowest point, m.
const SLACK_M: f64 = 1e-9;

impl Grid {
    /// The grid of these cutters, its cells about `cell_m` wide.
    pub(super) fn new(cutters: &[Cutter], body: &Body, profile: &Profile, cell_m: f64) -> Self {
        let boxes: Vec<_> = cutters.iter().map(Cutter::bounds).collect();
        let far = |b: &[Vector3<f64>; 2]| {
            let corner = b[0].abs().sup(&b[1].abs());
            libm::hypot(corner.x, corner.y)
        };
        let radius = boxes.iter().map(far).fold(profile.radius_m(), f64::max);
        let cells = (2.0 * radius / cell_m).ceil() as usize;
        let cells_per_m = cells as f64 / (2.0 * radius);
        let mut grid = Self {
            half_width_m: radius,
            cells_per_m,
            cells,
            starts: Vec::with_capacity(cells * cells + 1),
            cutters: Vec::new(),
            lowest_m: Vec::with_capacity(cells * cells),
            body_m: Vec::with_capacity(cells * cells),
            radius2_m2: radius * radius,
            z_m: [
                boxes.iter().fold(profile.top_z_m(), |z, b| z.min(b[0].z)),
                boxes.iter().fold(0.0, |z, b| z.max(b[1].z)),
            ],
        };
        let edge = |i: usize| i as f64 / cells_per_m - radius;
        for iy in 0..cells {
            for ix in 0..cells {
                let (x, y) = ([edge(ix), edge(ix + 1)], [edge(iy), edge(iy + 1)]);
                grid.starts.push(grid.cutters.len() as u32);
                let near = |a: [f64; 2]| if a[0] > 0.0 { a[0] } else { (-a[1]).max(0.0) };
                let farther = |a: [f64; 2]| a[1].max(-a[0]);
                let from = libm::hypot(near(x), near(y));
                let to = libm::hypot(farther(x), farther(y));
                // A point by the offset behind the profile is at least as far above it; the pads
                // end where the gauge begins.
                let body_m = if from <= body.pad_radius_m {
                    let face = profile.lowest_between_m(from, to) - body.offset_m;
                    face.max(profile.gauge_z_m()) + SLACK_M
                } else {
                    f64::NEG_INFINITY
                };
                let mut lowest = body_m;
                for (index, [low, high]) in boxes.iter().enumerate() {
                    if low.x <= x[1] && high.x >= x[0] && low.y <= y[1] && high.y >= y[0] {
                        grid.cutters.push(index as u16);
                        lowest = lowest.max(high.z);
                    }
                }
                grid.lowest_m.push(lowest);
                grid.body_m.push(body_m);
            }
        }
        grid.starts.push(grid.cutters.len() as u32);
        grid
    }

    /// The cutters that may hold a point, and whether the body may; nothing where all is above it.
    #[inline]
    pub(super) fn near(&self, position_m: Vector3<f64>) -> Option<(&[u16], bool)> {
        let index = |x: f64| {
            let cell = (x + self.half_width_m) * self.cells_per_m;
            (cell >= 0.0 && cell < self.cells as f64).then_some(cell as usize)
        };
        let cell = index(position_m.y)? * self.cells + index(position_m.x)?;
        if position_m.z > self.lowest_m[cell] {
            return None;
        }
        let [from, to] = [self.starts[cell], self.starts[cell + 1]];
        let cutters = &self.cutters[from as usize..to as usize];
        Some((cutters, position_m.z <= self.body_m[cell]))
    }
}
