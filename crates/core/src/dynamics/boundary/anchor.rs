//! Positions of the nodes' anchors on the hole's axis.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::{
    dynamics::kernel::chain::Chain,
    model::Model,
    rod::{bent::transported, mesh::Mesh},
    simd::{number::Real, vector::Vector},
};

/// Position of a node's anchor on the hole's axis.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Anchor {
    /// Measured depth, m.
    pub md_m: f64,
    /// Position, m.
    pub position_m: Vector3<f64>,
    /// Unit vector across the axis towards the high side.
    pub high_side: Vector3<f64>,
}

/// Position of a node at the middle of the last step of its region, m; the step of the uppermost
/// region is `dt`.
pub fn middle_m(
    chain: &Chain<impl Real>,
    anchors: &[Anchor],
    index: usize,
    dt: f64,
) -> Vector3<f64> {
    anchors[index].position_m + Vector3::from(chain.displacement(index))
        - 0.5 * chain.step_s(index, dt) * Vector3::from(chain.velocity(index))
}

// Forces across components, fixed in space.

/// Adds the lateral forces of components to the weights of their nodes: like the weights they keep
/// their direction while the string turns. Their tool faces are angles from the high side at the
/// bit, clockwise as one looks down the hole, carried up it without twisting.
pub fn add_lateral_forces(chain: &mut Chain, anchors: &[Anchor], model: &Model, mesh: &Mesh) {
    let last = chain.nodes() - 1;
    for span in model.string.spans() {
        let Some(load) = span.component.lateral_force else { continue };
        let index = mesh.nearest_inner_node(span.from_bit_m + load.from_lower_end_m);
        let mut high = Vector::from(anchors[last].high_side);
        for above in (index..last).rev() {
            high = transported(high, chain.tangent(above + 1), chain.tangent(above));
        }
        let right = chain.tangent(index).cross(high);
        let (sine, cosine) = libm::sincos(load.toolface_rad);
        let force = high.scaled(load.force_N * cosine).plus(right, load.force_N * sine);
        chain.set_weight(index, chain.weight(index) + force);
    }
}
