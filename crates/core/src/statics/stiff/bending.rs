//! How the elements bend between their nodes: [`beam_column`](crate::rod::beam_column).

use nalgebra::Vector3;

use super::{state::State, string_in_hole::StringInHole};
use crate::{
    ends::{BitEnd, TopEnd},
    rod::{
        beam_column::{BeamColumn, Middle},
        mesh::Mesh,
    },
    simd::vector::Vector,
};

/// What an element bears.
#[derive(Debug, Clone, Copy)]
struct Bent {
    /// Moment at the upper and at the lower end and half-way, N·m, towards the centre of curvature.
    upper_N_m: Vector3<f64>,
    lower_N_m: Vector3<f64>,
    half_way_N_m: f64,
    sag_m: f64,
    touches: f64,
    /// How much it holds its ends with, N·m.
    holds_N_m: f64,
}

/// What the nodes and the stretches below them bear, from the top down.
#[derive(Debug, Clone, Default)]
pub(super) struct Bending {
    /// At the node, N·m.
    pub(super) at_node_N_m: Vec<f64>,
    /// How far the elements on the two sides of the node are apart about it, N·m: what their
    /// lengths leave out.
    pub(super) jump_N_m: Vec<f64>,
    /// The same as a vector towards the centre of curvature.
    pub(super) towards_N_m: Vec<Vector3<f64>>,
    /// Half-way to the next, N·m; at the bit nothing.
    pub(super) between_N_m: Vec<f64>,
    /// Sag half-way, m.
    pub(super) sag_m: Vec<f64>,
    /// One where the body touches half-way.
    pub(super) touches: Vec<f64>,
}

impl Bending {
    /// Of the string as it is, with its buoyed weight in a mud of a density.
    pub(super) fn of(
        string: &StringInHole,
        state: &State,
        mesh: &Mesh,
        mud_kg_per_m3: f64,
    ) -> Self {
        let elements: Vec<Bent> = (0..string.elements.len())
            .map(|index| bent(string, state, mesh, index, mud_kg_per_m3))
            .collect();
        let mut bending = Self::default();
        for index in 0..string.nodes.len() {
            let above = index.checked_sub(1).map(|above| &elements[above]);
            let below = elements.get(index);
            // The two sides of a node agree but for what each mesh leaves out: by what they hold
            // it.
            let moment = match (above, below) {
                (Some(above), Some(below)) => {
                    let part = above.holds_N_m / (above.holds_N_m + below.holds_N_m);
                    below.upper_N_m * part + above.lower_N_m * (1.0 - part)
                }
                (None, Some(below)) if string.ends.top == TopEnd::Clamped => below.upper_N_m,
                (Some(above), None) if string.ends.bit == BitEnd::Clamped => above.lower_N_m,
                // An end that is free to tilt carries none.
                _ => Vector3::zeros(),
            };
            let jump = above.zip(below).map(|(above, below)| below.upper_N_m - above.lower_N_m);
            bending.at_node_N_m.push(moment.norm());
            bending.jump_N_m.push(jump.map_or(0.0, |jump| jump.norm()));
            bending.towards_N_m.push(moment);
            bending.between_N_m.push(below.map_or(0.0, |of| of.half_way_N_m));
            bending.sag_m.push(below.map_or(0.0, |of| of.sag_m));
            bending.touches.push(below.map_or(0.0, |of| of.touches));
        }
        bending
    }
}

fn bent(
    string: &StringInHole,
    state: &State,
    mesh: &Mesh,
    index: usize,
    mud_kg_per_m3: f64,
) -> Bent {
    let (element, section) = (&string.elements[index], &mesh.elements[index].section);
    let [upper, lower] = [index, index + 1].map(|node| state.moved_m(string, node));
    let k = &element.stiffness;
    let length_m = k.length;
    let t = state.chord_m(string, index).normalize();
    let across = |v: Vector3<f64>| v - t * t.dot(&v);
    let d1 = element.seen(&state.heading[index]);
    let d2 = state.heading[index + 1].along;
    let (odd, even) = (across(d1 + d2), across(d2 - d1));
    let tension_N = state.tension_N[index];
    let stiffness_N_m2 = section.bending_stiffness_N_m2;
    let pull_N_per_m = tension_N / length_m;
    let weight_N_per_m = across(Vector3::z()) * section.buoyed_weight_N_per_m(mud_kg_per_m3);
    let load = even * pull_N_per_m + weight_N_per_m;
    let column = BeamColumn::of(tension_N * length_m * length_m / (64.0 * stiffness_N_m2));
    let nodes = [&string.nodes[index], &string.nodes[index + 1]];
    // Half-way the hole is a quarter of what its two directions differ by off its chord.
    let hole = nodes[1].axes[2] - nodes[0].axes[2];
    let chord_middle = (upper + lower) * 0.5 + across(hole) * (0.125 * length_m);
    let middle = Middle {
        load: Vector::from(load),
        offset: Vector::from(across(chord_middle - even * (0.125 * length_m))),
        clearance: string.elements[index].body_clearance_m,
    };
    let shape = column.bent(length_m, stiffness_N_m2, &middle);
    let by = |part: f64| even * (k.bending + part * pull_N_per_m) + weight_N_per_m * part;
    // `EI/L`, of which shear takes its part.
    let turned = (k.bending_far + k.bending) / 3.0 * column.odd();
    let (at_ends, off) = (by(shape.at_ends), odd * turned);
    Bent {
        upper_N_m: at_ends - off,
        lower_N_m: at_ends + off,
        half_way_N_m: by(shape.half_way).norm(),
        sag_m: shape.sag,
        touches: shape.touches,
        holds_N_m: k.bending + pull_N_per_m * shape.at_ends + turned,
    }
}
