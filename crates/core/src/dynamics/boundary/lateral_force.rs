//! Forces across components, fixed in space.

use super::anchor::Anchor;
use crate::{
    dynamics::kernel::chain::Chain,
    model::Model,
    rod::{bent::transported, mesh::Mesh},
    simd::vector::Vector,
};

/// Adds the lateral forces of components to the weights of their nodes: like the weights they keep
/// their direction while the string turns. Their tool faces are angles from the high side at the
/// bit, clockwise as one looks down the hole, carried up it without twisting.
pub fn add(chain: &mut Chain, anchors: &[Anchor], model: &Model, mesh: &Mesh) {
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
