//! Position of the string's axis in its hole.

use nalgebra::Vector3;

use super::{bending::Bending, state::State, string_in_hole::StringInHole};
use crate::model::Model;

/// Position of the string's axis in its hole, from the surface to the bit. Each pair is the
/// component towards the high side and that to the right of it, looking down the hole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StringAxis {
    /// Offset from the hole's axis, m.
    pub offset_m: Vec<[f64; 2]>,
    /// Tilt of the axis downwards against the hole's, rad; at a bend that of the part above it.
    pub tilt_rad: Vec<[f64; 2]>,
    /// Contact force on the wall, N; at the bit the force that holds it to the axis.
    pub push_N: Vec<[f64; 2]>,
    /// Bending moment, N·m, towards the centre of curvature.
    pub moment_N_m: Vec<[f64; 2]>,
    /// Radius of the hole, m.
    pub hole_radius_m: Vec<f64>,
}

impl StringAxis {
    pub(super) fn new(
        model: &Model,
        string: &StringInHole,
        state: &State,
        bending: &Bending,
    ) -> Self {
        let mut axis = Self::default();
        for (index, node) in string.nodes.iter().enumerate() {
            let [e1, e2, tangent] = node.axes;
            let high = model.well.path.high_side_of(node.md_m, &tangent);
            let right = tangent.cross(&high);
            let parts = |vector: Vector3<f64>| [vector.dot(&high), vector.dot(&right)];
            let u = state.offset_m[index];
            let offset = e1 * u.x + e2 * u.y;
            let toward = offset / offset.norm().max(f64::MIN_POSITIVE);
            let push = toward * state.normal_N[index] + offset * node.hold_N_per_m;
            axis.offset_m.push(parts(offset));
            axis.tilt_rad.push(parts(state.heading[index].along));
            axis.push_N.push(parts(push));
            axis.moment_N_m.push(parts(bending.towards_N_m[index]));
            axis.hole_radius_m.push(if node.has_wall() {
                node.clearance_m + node.contact_radius_m
            } else {
                0.5 * model.well.hole.at(node.md_m).diameter_m
            });
        }
        axis
    }

    /// Measured depth at which the string crosses the hole's axis downwards, from the high to the
    /// low half, m. `md_m` are the measured depths of the nodes. Returns the crossing nearest to
    /// `near_m`, if it is no farther from it than `within_m`.
    pub(super) fn crossing_near_m(&self, md_m: &[f64], near_m: f64, within_m: f64) -> Option<f64> {
        let pairs = md_m.windows(2).zip(self.offset_m.windows(2));
        let crossings = pairs.filter_map(|(md_m, offset_m)| {
            let ([above_m, _], [below_m, _]) = (offset_m[0], offset_m[1]);
            (above_m > 0.0 && below_m <= 0.0)
                .then(|| md_m[0] + (md_m[1] - md_m[0]) * above_m / (above_m - below_m))
        });
        let off = |at_m: &f64| (at_m - near_m).abs();
        crossings.filter(|at_m| off(at_m) <= within_m).min_by(|a, b| off(a).total_cmp(&off(b)))
    }
}
