//! Loads on the nodes other than those of the wall.

use nalgebra::Vector3;

use super::{
    element::{Couples, Element},
    node::Node,
};
use crate::{
    model::Model,
    rod::{in_fluid::ElementInFluid, mesh::Mesh},
    statics::circulation::Circulating,
};

/// Adds the buoyed weight of the elements and the pull of the mud to the nodes at their ends.
pub(super) fn add_weight(
    nodes: &mut [Node],
    mesh: &Mesh,
    circulating: &[Circulating],
    in_fluid: &[ElementInFluid],
) {
    let elements = mesh.elements.iter().zip(circulating).zip(in_fluid);
    for (index, ((element, flow), fluid)) in elements.enumerate() {
        let weight_N = 0.5 * element.length_m * fluid.weight_N_per_m;
        let pull_N = 0.5 * element.length_m * flow.pull_N_per_m;
        for node in &mut nodes[index..=index + 1] {
            // A pull that adds to hook load points to the bit.
            node.load_N += Vector3::z() * weight_N + node.axes[2] * pull_N;
        }
    }
}

/// Gives each element the fixed-end moments of the loads between its nodes.
pub(super) fn add_couples(
    elements: &mut [Element],
    nodes: &[Node],
    mesh: &Mesh,
    in_fluid: &[ElementInFluid],
) {
    for (index, (element, cut)) in elements.iter_mut().zip(&mesh.elements).enumerate() {
        let part_m = cut.length_m / 12.0;
        let weight_N = in_fluid[index].weight_N_per_m * cut.length_m;
        let chord = element.anchor_chord_m.normalize();
        let across = Vector3::z() - chord * chord.z;
        let turn = nodes[index + 1].axes[2] - nodes[index].axes[2];
        element.couples = Couples {
            hanging_N_m: across * (weight_N * part_m),
            lying_N_m: turn * (-element.guess_N * part_m),
        };
    }
}

/// Pulls at the bit with a tension, N.
pub(super) fn add_pull(nodes: &mut [Node], tension_N: f64) {
    if let Some(bit) = nodes.last_mut() {
        bit.load_N += bit.axes[2] * tension_N;
    }
}

/// Adds the lateral forces of components, at their tool faces: angles from the high side at the
/// bit, which has the parts `high_rad` everywhere.
pub(super) fn add_lateral(nodes: &mut [Node], model: &Model, mesh: &Mesh, high_rad: f64) {
    for span in model.string.spans() {
        let Some(lateral) = span.component.lateral_force else { continue };
        let node = &mut nodes[mesh.nearest_inner_node(span.from_bit_m + lateral.from_lower_end_m)];
        node.load_N += node.across(high_rad + lateral.toolface_rad) * lateral.force_N;
    }
}
