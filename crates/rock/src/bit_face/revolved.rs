//! Convex solids of revolution: cutters and inserts.

/// A convex solid of revolution, rounded: all points within `rounding` of a convex polygon turned
/// about its axis.
///
/// Coordinates are the distance `ρ` from the axis and the height `ζ` along it. A disc with a
/// chamfer is a polygon without rounding, a hemispherical insert a piece of the axis with its
/// radius, a conical one a cone rounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Revolved {
    /// Corners from the top of the axis to its bottom; the last one repeats.
    corners: [[f64; 2]; CORNERS],
    /// Outward normals of the edges between them.
    normals: [[f64; 2]; CORNERS - 1],
    edges: usize,
    rounding_m: f64,
}

/// Most corners of a polygon.
const CORNERS: usize = 5;

impl Revolved {
    /// The solid of this polygon, whose first and last corners are on the axis, the first on top.
    /// Corners that coincide are one.
    pub(super) fn new(outline: &[[f64; 2]], rounding_m: f64) -> Self {
        let mut corners = [outline[0]; CORNERS];
        let mut normals = [[1.0, 0.0]; CORNERS - 1];
        let mut edges = 0;
        for &corner in &outline[1..] {
            let along = [corner[0] - corners[edges][0], corner[1] - corners[edges][1]];
            let length = libm::hypot(along[0], along[1]);
            if length > 0.0 {
                normals[edges] = [-along[1] / length, along[0] / length];
                edges += 1;
                corners[edges] = corner;
            }
        }
        for at in edges + 1..CORNERS {
            corners[at] = corners[edges];
        }
        Self { corners, normals, edges, rounding_m }
    }

    /// Distance of a point from the surface, negative inside, m, and the direction in which it
    /// grows.
    pub(super) fn distance(&self, rho: f64, zeta: f64) -> (f64, [f64; 2]) {
        let (mut distance, mut normal) = self.farthest_edge(rho, zeta);
        if distance > 0.0 {
            (distance, normal) = self.outside(rho, zeta);
        }
        (distance - self.rounding_m, normal)
    }

    /// Depth of a point inside, m, and the shortest direction out.
    #[inline]
    pub(super) fn depth(&self, rho: f64, zeta: f64) -> Option<(f64, [f64; 2])> {
        let (mut distance, mut normal) = self.farthest_edge(rho, zeta);
        if distance >= self.rounding_m && distance > 0.0 {
            return None;
        }
        if distance > 0.0 {
            (distance, normal) = self.outside(rho, zeta);
        }
        let depth = self.rounding_m - distance;
        (depth > 0.0).then_some((depth, normal))
    }

    /// Largest distance from the lines through the edges, that of the polygon if it is negative.
    #[inline]
    fn farthest_edge(&self, rho: f64, zeta: f64) -> (f64, [f64; 2]) {
        let mut farthest = (f64::NEG_INFINITY, [0.0, 1.0]);
        for edge in 0..self.edges {
            let (a, n) = (self.corners[edge], self.normals[edge]);
            let distance = n[0] * (rho - a[0]) + n[1] * (zeta - a[1]);
            if distance > farthest.0 {
                farthest = (distance, n);
            }
        }
        farthest
    }

    /// Distance from the polygon of a point outside it.
    fn outside(&self, rho: f64, zeta: f64) -> (f64, [f64; 2]) {
        let mut nearest = (f64::INFINITY, [0.0, 1.0]);
        for edge in 0..self.edges {
            let (a, b) = (self.corners[edge], self.corners[edge + 1]);
            let (along, from) = ([b[0] - a[0], b[1] - a[1]], [rho - a[0], zeta - a[1]]);
            let share = (from[0] * along[0] + from[1] * along[1])
                / (along[0] * along[0] + along[1] * along[1]);
            let share = share.clamp(0.0, 1.0);
            let off = [from[0] - share * along[0], from[1] - share * along[1]];
            let distance = libm::hypot(off[0], off[1]);
            if distance < nearest.0 {
                let inverse = 1.0 / distance.max(f64::MIN_POSITIVE);
                nearest = (distance, [off[0] * inverse, off[1] * inverse]);
            }
        }
        nearest
    }

    /// Largest distance from the axis, lowest and highest point along it, m.
    pub(super) fn extent(&self) -> (f64, [f64; 2]) {
        let corners = &self.corners[..=self.edges];
        let fold = |start: f64, pick: fn(f64, f64) -> f64, axis: usize| {
            corners.iter().fold(start, |least, c| pick(least, c[axis]))
        };
        (
            fold(0.0, f64::max, 0) + self.rounding_m,
            [
                fold(f64::INFINITY, f64::min, 1) - self.rounding_m,
                fold(f64::NEG_INFINITY, f64::max, 1) + self.rounding_m,
            ],
        )
    }
}
