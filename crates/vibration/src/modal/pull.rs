//! Stiffness and mass of the string's nodes for small vibrations.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::{
    chain::{Chain, Entry},
    factors::Stiffness,
};
use wholestring::{
    dynamics::{DynamicsSettings, HoistControl, lateral_mass_kg_per_m},
    ends::{BitEnd, TopEnd},
    model::Model,
    operation::Operation,
    rod::{dual, stability},
    statics::stiff::{AtRest, NodeAtRest},
};

/// Motion of a bend of the body with the spin of its node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bend {
    /// It turns with the node: the tool face is that at rest, and has the energy of weight and
    /// wall.
    AtItsToolFace,
    /// Averaged over the tool faces of a turn, in which that energy is periodic, so that its second
    /// derivative is zero on average: the spin goes around the bend and leaves it where it is.
    AveragedOverATurn,
}

/// A node's motions in the axes of the world: three displacements, three rotations.
fn axes(node: &NodeAtRest) -> Stiffness {
    let mut both = Stiffness::zeros();
    both.fixed_view_mut::<3, 3>(0, 0).copy_from(&Matrix3::from_columns(&node.axes));
    both.fixed_view_mut::<3, 3>(3, 3).copy_from(&Matrix3::from_columns(&node.frame));
    both
}

/// The same of a bent body below its bend, whose director is another: tilts move it, and the spin
/// is about it.
fn axes_around(node: &NodeAtRest, director: Vector3<f64>) -> Stiffness {
    let [b1, b2, _] = node.frame;
    let across = |tilt: Vector3<f64>| tilt - director * tilt.dot(&director);
    let mut both = axes(node);
    both.fixed_view_mut::<3, 3>(3, 3).copy_from(&Matrix3::from_columns(&[
        across(b1),
        across(b2),
        director,
    ]));
    both
}

/// Whether the body of an element is bent at its upper node.
fn is_bent(rest: &AtRest, element: usize) -> bool {
    Vector3::from(rest.elements[element].pose.d1) != rest.nodes[element].frame[2]
}

/// Whether any body of the string is bent.
pub(super) fn has_bend(rest: &AtRest) -> bool {
    (0..rest.elements.len()).any(|element| is_bent(rest, element))
}

/// The chain of a string at rest.
///
/// The stiffness is the exact tangent of the elements. A moment that follows the rotation of its
/// node, as the torque of friction and bit, has a part in it that is not symmetric: half of the
/// moment at a node, which is negligible compared with its bending stiffness and is left out.
pub(super) fn chain(
    model: &Model,
    operation: &Operation,
    dynamics: &DynamicsSettings,
    rest: &AtRest,
    bend: Bend,
) -> Chain {
    let mut chain = Chain::free(rest.nodes.len());
    let turned: Vec<Stiffness> = rest.nodes.iter().map(axes).collect();
    for (index, element) in rest.elements.iter().enumerate() {
        let tangent: SMatrix<f64, 12, 12> = dual::tangent(&element.stiffness, &element.pose);
        let mut ends = [turned[index], turned[index + 1]];
        if bend == Bend::AveragedOverATurn && is_bent(rest, index) {
            ends[0] = axes_around(&rest.nodes[index], element.pose.d1.into());
        }
        let block = |row: usize, column: usize| {
            let fixed_view = tangent.fixed_view::<6, 6>(6 * row, 6 * column);
            ends[row].tr_mul(&(fixed_view * ends[column]))
        };
        chain.diagonal[index] += block(0, 0);
        chain.diagonal[index + 1] += block(1, 1);
        chain.upper[index] = (block(0, 1) + block(1, 0).transpose()) * 0.5;
    }
    for (diagonal, node) in chain.diagonal.iter_mut().zip(&rest.nodes) {
        *diagonal = (*diagonal + diagonal.transpose()) * 0.5;
        let mut across = diagonal.fixed_view_mut::<2, 2>(0, 0);
        across += node.held_N_per_m;
    }
    weigh(&mut chain, model, operation, rest);
    hold_ends(&mut chain, model, operation, dynamics);
    chain
}

/// The dynamics' inertia, without the mass added for its time step.
fn weigh(chain: &mut Chain, model: &Model, operation: &Operation, rest: &AtRest) {
    let lateral = lateral_mass_kg_per_m(model, &rest.mesh, operation.bit_depth_m);
    let elements = stability::bare_elements(&rest.mesh, &lateral);
    for (index, (_, inertia)) in elements.iter().enumerate() {
        let [across, along] = [0.5 * inertia.lateral_kg, 0.5 * inertia.axial_kg];
        let (tilt, about) = (inertia.rotary_kg_m2, 0.5 * inertia.polar_kg_m2);
        for end in [index, index + 1] {
            chain.mass[end] += Entry::new(across, across, along, tilt, tilt, about);
            chain.polar_kg_m2[end] += about;
        }
    }
}

/// The hoist's line and block along the string, the top on the hole's axis and turned at a speed
/// that is given; under a bit on bottom the rock.
fn hold_ends(chain: &mut Chain, model: &Model, operation: &Operation, dynamics: &DynamicsSettings) {
    let line = &dynamics.hoist_line;
    chain.mass[0][2] += line.block_mass_kg;
    if !matches!(dynamics.hoist_control, Some(HoistControl::HookLoad(_))) {
        chain.diagonal[0][(2, 2)] += line.stiffness_N_per_m;
    }
    chain.hold(
        0,
        match model.ends.top {
            TopEnd::Clamped => &[0, 1, 3, 4, 5],
            TopEnd::Pinned => &[0, 1, 5],
        },
    );
    let last = chain.nodes() - 1;
    match model.ends.bit {
        BitEnd::Held | BitEnd::Free => {}
        BitEnd::Pinned => chain.hold(last, &[0, 1]),
        BitEnd::Clamped => chain.hold(last, &[0, 1, 3, 4]),
    }
    if operation.kind.on_bottom() {
        chain.diagonal[last][(2, 2)] += dynamics.bit.law.stiffness_N_per_m();
    }
}
