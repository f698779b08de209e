//! The elements between the nodes, and the mud that flows along them.

use nalgebra::Vector3;

use super::{super::director::Heading, node::Node};
use crate::{
    model::Model,
    mud::{Conduit, Hydraulics},
    operation::Operation,
    rod::{
        element::Stiffness,
        mesh::{Mesh, MeshElement},
        tangent::Ends,
    },
    statics::{
        circulation::{self, Circulating, Passage},
        soft::SoftProfile,
    },
    wall::Bore,
};

/// Fixed-end moments of the loads between the nodes of an element, N·m.
#[derive(Debug, Clone, Copy, Default)]
pub(in super::super) struct Couples {
    /// Of its buoyed weight `q` per length across its chord, `q L²/12`.
    pub(in super::super) hanging_N_m: Vector3<f64>,
    /// Of weight and wall where its body lies along the hole: together they balance the tension in
    /// the hole's curvature, `−T κ L²/12`.
    pub(in super::super) lying_N_m: Vector3<f64>,
}

/// An element between a node and the next.
#[derive(Debug, Clone)]
pub(in super::super) struct Element {
    /// From its upper node's place on the hole's axis to its lower node's, m.
    pub(in super::super) anchor_chord_m: Vector3<f64>,
    /// Its stiffness.
    pub(in super::super) stiffness: Stiffness<f64>,
    /// `g` of the element without tension, m: where it lies on the wall as the soft string does, it
    /// has that one's tension.
    pub(in super::super) slack_m: f64,
    /// That tension, N.
    pub(in super::super) guess_N: f64,
    /// Torque of the mud against its rotation, N·m.
    pub(in super::super) mud_torque_N_m: f64,
    /// Director that it sees at its upper node, in components of the node's frame, the last along
    /// the node's director. None where the body has no bend there.
    pub(in super::super) bend: Option<Vector3<f64>>,
    /// Clearance of its body half-way, from the hole's axis, m.
    pub(in super::super) body_clearance_m: f64,
    /// Moments on its upper director by the loads between its nodes, N·m; reversed on the lower
    /// one.
    pub(in super::super) couples: Couples,
    /// Whether it hangs between its nodes, off the wall.
    pub(in super::super) hangs: bool,
}

impl Element {
    /// The director that it sees at its upper node.
    pub(in super::super) fn seen(&self, heading: &Heading) -> Vector3<f64> {
        let [b1, b2] = heading.across;
        let parts = self.bend.unwrap_or_else(Vector3::z);
        b1 * parts.x + b2 * parts.y + heading.along * parts.z
    }

    /// The moment on its upper director by the loads between its nodes, N·m.
    pub(in super::super) fn couple_N_m(&self) -> Vector3<f64> {
        if self.hangs { self.couples.hanging_N_m } else { self.couples.lying_N_m }
    }
}

/// The elements between nodes, the bends of the body left out.
pub(super) fn between(
    mesh: &Mesh,
    bore: &Bore,
    nodes: &[Node],
    circulating: &[Circulating],
    (soft, inside_m): (&SoftProfile, &[f64]),
) -> Vec<Element> {
    let pairs = nodes.windows(2).zip(&mesh.elements).zip(circulating).zip(inside_m);
    type Pair<'a> = (((&'a [Node], &'a MeshElement), &'a Circulating), &'a f64);
    let element = |(((pair, cut), flow), inside_m): Pair<'_>| {
        let (upper, lower) = (&pair[0], &pair[1]);
        let stiffness = Stiffness::new(&cut.section, cut.length_m);
        let middle_m = 0.5 * (upper.md_m + lower.md_m);
        let guess_N = soft.tension_at_N(middle_m);
        let anchor_chord_m = lower.anchor_m - upper.anchor_m;
        let centred = Ends { chord_m: anchor_chord_m, directors: [upper.axes[2], lower.axes[2]] };
        Element {
            anchor_chord_m,
            slack_m: centred.longer_m(&stiffness) - inside_m - guess_N / stiffness.axial,
            stiffness,
            guess_N,
            mud_torque_N_m: cut.length_m * flow.torque_N_m_per_m,
            bend: None,
            body_clearance_m: bore.smooth_radius_m(middle_m) - 0.5 * cut.section.od_m,
            couples: Couples::default(),
            hangs: true,
        }
    };
    pairs.map(element).collect()
}

/// Bends the elements below the bends of the body, at their tool faces: angles from the high side
/// at the bit, which has the parts `high_rad` everywhere.
pub(super) fn bend(elements: &mut [Element], model: &Model, mesh: &Mesh, high_rad: f64) {
    for span in model.string.spans() {
        let Some(bend) = span.component.bend else { continue };
        let index = mesh.nearest_inner_node(span.from_bit_m + bend.from_lower_end_m);
        let (sine, cosine) = libm::sincos(high_rad + bend.toolface_rad);
        let (across, along) = libm::sincos(bend.angle_rad);
        elements[index].bend = Some(Vector3::new(across * cosine, across * sine, along));
    }
}

/// Effect of the mud on each element, from the top down.
pub(super) fn circulation(
    model: &Model,
    operation: &Operation,
    mesh: &Mesh,
    depths_m: &[f64],
) -> (Vec<Circulating>, Option<Hydraulics>) {
    let passages: Vec<Passage> = (0..mesh.elements.len())
        .rev()
        .map(|index| {
            let element = &mesh.elements[index];
            let nodes = [&mesh.nodes[index + 1], &mesh.nodes[index]];
            let middle_m = 0.5 * (depths_m[index] + depths_m[index + 1]);
            let conduit = Conduit::between(
                &model.string,
                &model.well.hole,
                nodes.map(|node| node.from_bit_m),
                [depths_m[index + 1], depths_m[index]],
            );
            Passage {
                length_m: element.length_m,
                conduit,
                free_strain: element.section.free_strain(),
                inside: model.fluids.inside_at(&model.mud, middle_m),
                annulus: model.fluids.annulus_at(&model.mud, middle_m),
            }
        })
        .collect();
    let (mut circulating, hydraulics) = circulation::along(model, operation, &passages);
    circulating.reverse();
    (circulating, hydraulics)
}
