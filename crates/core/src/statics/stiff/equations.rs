//! Equilibrium of the string without its wall: forces of the elements, the weight and the ends at
//! every node, and their derivatives.

#[cfg(test)]
mod tests;

use nalgebra::{Matrix3, SMatrix, Vector2, Vector3};

use super::{
    blocks::{Block, Entry, Tridiagonal},
    contact::Push,
    director::Director,
    state::State,
    string_in_hole::StringInHole,
};
use crate::{
    ends::{BitEnd, TopEnd},
    rod::tangent::{Ends, Gradient, Tangent},
};

/// The equations of a Newton step, without the wall: `matrix · step = force`.
#[derive(Debug, Clone)]
pub(super) struct Equations {
    /// Derivative of the forces that hold the nodes with respect to their positions.
    pub(super) matrix: Tridiagonal,
    /// Unbalanced forces on the nodes and moments on their directors.
    pub(super) force: Vec<Entry>,
    /// Derivative of each element's length with respect to the positions of its two nodes, and the
    /// excess of its length over that of its tension, m.
    lengthening: Vec<Lengthening>,
    /// Force that carries the string at its top, N.
    pub(super) hook_load_N: f64,
    /// Lateral force of the bit on the constraint that holds it to the axis, N, where its end has
    /// one.
    pub(super) bit_side_N: Vector2<f64>,
}

#[derive(Debug, Clone, Copy)]
struct Lengthening {
    ends: [Entry; 2],
    excess_m: f64,
    axial_N_per_m: f64,
}

impl Equations {
    /// Equations of this many nodes.
    pub(super) fn new(nodes: usize) -> Self {
        Self {
            matrix: Tridiagonal::zeros(nodes),
            force: vec![Entry::zeros(); nodes],
            lengthening: Vec::with_capacity(nodes),
            hook_load_N: 0.0,
            bit_side_N: Vector2::zeros(),
        }
    }

    /// Assembles the equations of a state of the string under the torque of each element, N·m.
    /// Without `torque_N_m` the matrix is the second derivative of an energy, and symmetric.
    pub(super) fn assemble(
        &mut self,
        string: &StringInHole,
        state: &State,
        torque_N_m: Option<&[f64]>,
    ) {
        self.matrix.clear();
        self.lengthening.clear();
        for (index, node) in string.nodes.iter().enumerate() {
            let u = state.offset_m[index];
            let held = Vector3::new(node.hold_N_per_m, node.hold_N_per_m, 0.0);
            let force = local(&node.axes, node.load_N) - held.component_mul(&u);
            self.force[index] = Entry::new(force.x, force.y, force.z, 0.0, 0.0);
            let diagonal = &mut self.matrix.diagonal[index];
            diagonal[(0, 0)] = node.hold_N_per_m;
            diagonal[(1, 1)] = node.hold_N_per_m;
        }
        for index in 0..string.elements.len() {
            self.add_element(string, state, index, torque_N_m);
        }
        if let Some([top_N_m, .., bit_N_m] | [top_N_m @ bit_N_m]) = torque_N_m {
            self.turn_ends(string, state, [*top_N_m, *bit_N_m]);
        }
        self.hold_ends(string);
    }

    fn add_element(
        &mut self,
        string: &StringInHole,
        state: &State,
        index: usize,
        torque_N_m: Option<&[f64]>,
    ) {
        let element = &string.elements[index];
        let nodes = [&string.nodes[index], &string.nodes[index + 1]];
        let headings = [&state.heading[index], &state.heading[index + 1]];
        let seen = seen(string, state, index);
        let directors = [seen[0].along, seen[1].along];
        let ends = Ends { chord_m: state.chord_m(string, index), directors };
        let tension_N = state.tension_N[index];
        let mut tangent = Tangent::of(&element.stiffness, &ends, tension_N);
        let couple_N_m = element.couple_N_m();
        for (end, load_N_m) in [(0, couple_N_m), (1, -couple_N_m)] {
            tangent.gradient.directors[end] -= load_N_m;
            tangent.pull_N_m[end] -= load_N_m.dot(&directors[end]);
        }
        let axial_N_per_m = element.stiffness.axial;
        let excess_m = tangent.longer_m - element.slack_m - tension_N / axial_N_per_m;
        let axes = nodes.map(|node| Matrix3::from_columns(&node.axes));
        let entry = |gradient: &Gradient, end: usize| {
            let sign = if end == 0 { -1.0 } else { 1.0 };
            let force = transposed_product(&axes[end], &gradient.chord) * sign;
            let moment = transposed_product(&seen[end].by, &gradient.directors[end]);
            Entry::new(force.x, force.y, force.z, moment.x, moment.y)
        };
        let lengthening = [0, 1].map(|end| entry(&tangent.lengthening, end));
        // The symmetric blocks of the energy, its tension condensed.
        let by_chord = [0, 1].map(|end| tangent.chord_chord * axes[end]);
        let by_director = [0, 1].map(|end| tangent.chord_director[end] * seen[end].by);
        let sign = |end: usize| if end == 0 { -1.0 } else { 1.0 };
        let block = |row: usize, column: usize| {
            let mut block = Block::zeros();
            let rr = transposed_product(&axes[row], &by_chord[column]) * (sign(row) * sign(column));
            block.fixed_view_mut::<3, 3>(0, 0).copy_from(&rr);
            let rd = transposed_product(&axes[row], &by_director[column]) * sign(row);
            block.fixed_view_mut::<3, 2>(0, 3).copy_from(&rd);
            let dr = transposed_product(&by_director[row], &axes[column]) * sign(column);
            block.fixed_view_mut::<2, 3>(3, 0).copy_from(&dr);
            let dd = if row == column {
                transposed_product(&seen[row].by, &(tangent.director[row] * seen[row].by))
                    + seen[row].second(
                        headings[row],
                        tangent.gradient.directors[row],
                        tangent.pull_N_m[row],
                    )
            } else {
                transposed_product(&seen[0].by, &(tangent.director_director * seen[1].by))
            };
            block.fixed_view_mut::<2, 2>(3, 3).copy_from(&dd);
            block + lengthening[row] * (lengthening[column].transpose() * axial_N_per_m)
        };
        self.matrix.diagonal[index] += block(0, 0);
        self.matrix.diagonal[index + 1] += block(1, 1);
        let upper = block(0, 1);
        self.matrix.upper[index] = upper;
        self.matrix.lower[index] = upper.transpose();
        for end in [0, 1] {
            let unbalanced =
                entry(&tangent.gradient, end) + lengthening[end] * (axial_N_per_m * excess_m);
            self.force[index + end] -= unbalanced;
        }
        self.lengthening.push(Lengthening { ends: lengthening, excess_m, axial_N_per_m });
        if let Some(torques) = torque_N_m
            && torques[index] != 0.0
        {
            self.add_couple(index, torques[index], &seen);
        }
    }

    /// Removes the contribution of the torques under which the matrix was assembled: it is then the
    /// second derivative of an energy.
    pub(super) fn untwist(&mut self, string: &StringInHole, state: &State, torque_N_m: &[f64]) {
        for (index, torque_N_m) in torque_N_m.iter().enumerate() {
            if *torque_N_m != 0.0 {
                self.add_couple(index, -torque_N_m, &seen(string, state, index));
            }
        }
        if let [top_N_m, .., bit_N_m] | [top_N_m @ bit_N_m] = torque_N_m {
            self.turn_ends(string, state, [-top_N_m, -bit_N_m]);
        }
        self.hold_unknowns(string);
    }

    /// Adds the torques at the top and at the bit where those are free to tilt. They act as by a
    /// joint that turns alike on both sides, about the direction half-way between the hole's and
    /// the string's: about either of the two, a couple has a component about the hole's axis that
    /// nothing balances, which drives a buckled pipe around a vertical hole for ever.
    fn turn_ends(&mut self, string: &StringInHole, state: &State, [top_N_m, bit_N_m]: [f64; 2]) {
        for (node, moment_N_m) in [(0, top_N_m), (self.force.len() - 1, -bit_N_m)] {
            let director = Director::of(&state.heading[node], None);
            let axis = string.nodes[node].axes[2];
            let about = axis * (moment_N_m / (1.0 + axis.dot(&director.along)));
            let force = director.by.tr_mul(&about.cross(&director.along));
            self.force[node][3] += force.x;
            self.force[node][4] += force.y;
            let change = director.by.tr_mul(&(about.cross_matrix() * director.by));
            let mut moments = self.matrix.diagonal[node].fixed_view_mut::<2, 2>(3, 3);
            moments -= change;
        }
    }

    /// Adds the couple `−M (d1 + d2)/(1 + c12)` of the torque `M` in the string on end 1, and the
    /// opposite on end 2.
    fn add_couple(&mut self, index: usize, torque_N_m: f64, seen: &[Director; 2]) {
        let [d1, d2] = [seen[0].along, seen[1].along];
        let share = torque_N_m / (1.0 + d1.dot(&d2));
        // On a director it is moment × director, the same at both ends.
        let on = d1.cross(&d2) * share;
        let forces: [Vector2<f64>; 2] = [0, 1].map(|end| transposed_product(&seen[end].by, &on));
        let cross = |d: Vector3<f64>| d.cross_matrix() * share;
        // ∂(d1 × d2) = −[d2×] ∂d1 + [d1×] ∂d2.
        let by = [-cross(d2) * seen[0].by, cross(d1) * seen[1].by];
        for end in [0, 1] {
            let force = &mut self.force[index + end];
            force[3] += forces[end].x;
            force[4] += forces[end].y;
            for other in [0, 1] {
                let change = transposed_product(&seen[end].by, &by[other]);
                let block = match (end, other) {
                    (0, 1) => &mut self.matrix.upper[index],
                    (1, 0) => &mut self.matrix.lower[index],
                    _ => &mut self.matrix.diagonal[index + end],
                };
                let mut moments = block.fixed_view_mut::<2, 2>(3, 3);
                moments -= change;
            }
        }
    }

    /// Constrains the ends, and stores the forces that hold them.
    fn hold_ends(&mut self, string: &StringInHole) {
        let last = self.force.len() - 1;
        self.hook_load_N = self.force[0][2];
        self.bit_side_N = self.force[last].fixed_rows::<2>(0).into_owned();
        self.hold_unknowns(string);
    }

    /// Constrains the unknowns of the ends. The top does not move, nor turn if it is clamped. The
    /// bit moves along the hole, and across it as its end allows.
    fn hold_unknowns(&mut self, string: &StringInHole) {
        let last = self.force.len() - 1;
        let held: &[usize] = match string.ends.top {
            TopEnd::Clamped => &[0, 1, 2, 3, 4],
            TopEnd::Pinned => &[0, 1, 2],
        };
        for row in held {
            self.hold(0, *row);
        }
        let held: &[usize] = match string.ends.bit {
            BitEnd::Held | BitEnd::Free => &[],
            BitEnd::Pinned => &[0, 1],
            BitEnd::Clamped => &[0, 1, 3, 4],
        };
        for row in held {
            self.hold(last, *row);
        }
    }

    /// Constrains an unknown of a node to its present value.
    fn hold(&mut self, node: usize, row: usize) {
        self.force[node][row] = 0.0;
        self.matrix.hold(node, row);
    }

    /// Adds this stiffness across the hole to the matrix, N/m (Levenberg's regularisation), so that
    /// motions without a change of energy, such as around a vertical hole, have a solution. The
    /// equilibria are not changed by it.
    pub(super) fn shift_across(&mut self, by_N_per_m: f64) {
        for diagonal in &mut self.matrix.diagonal {
            diagonal[(0, 0)] += by_N_per_m;
            diagonal[(1, 1)] += by_N_per_m;
        }
    }

    /// Whether the matrix is positive definite with this shift, N/m.
    pub(super) fn is_definite(&self, by_N_per_m: f64) -> bool {
        let shift = Entry::new(by_N_per_m, by_N_per_m, 0.0, 0.0, 0.0);
        self.matrix.is_positive_definite(&shift)
    }

    /// Adds the wall of a node, its contact force condensed: the force and its change at a fixed
    /// offset, N, and its change per metre of offset.
    pub(super) fn press(
        &mut self,
        index: usize,
        push: &Push,
        [normal_N, change_N]: [f64; 2],
        by_offset_N_per_m: &Vector2<f64>,
    ) {
        let force = push.force * (normal_N + change_N);
        let target = &mut self.force[index];
        let diagonal = &mut self.matrix.diagonal[index];
        for row in 0..3 {
            target[row] += force[row];
            for column in 0..2 {
                diagonal[(row, column)] -= push.force[row] * by_offset_N_per_m[column];
            }
        }
        let mut across = diagonal.fixed_view_mut::<2, 2>(0, 0);
        across -= push.change * normal_N;
    }

    /// Changes the tensions by a part of their change in the step, which the solution has left in
    /// `force`.
    pub(super) fn stretch(&self, state: &mut State, part: f64) {
        for (index, (element, tension_N)) in
            self.lengthening.iter().zip(&mut state.tension_N).enumerate()
        {
            let step = &self.force[index..=index + 1];
            let lengthening_m = element.ends[0].dot(&step[0]) + element.ends[1].dot(&step[1]);
            *tension_N += part * element.axial_N_per_m * (lengthening_m + element.excess_m);
        }
    }

    /// The largest difference between a tension and that of its element's shape, N.
    pub(super) fn misfit_N(&self) -> f64 {
        self.lengthening
            .iter()
            .map(|element| (element.axial_N_per_m * element.excess_m).abs())
            .fold(0.0, f64::max)
    }
}

/// The directors that an element sees.
fn seen(string: &StringInHole, state: &State, index: usize) -> [Director; 2] {
    let [upper, lower] = [index, index + 1].map(|node| &state.heading[node]);
    [Director::of(upper, string.elements[index].bend.as_ref()), Director::of(lower, None)]
}

/// `Aᵀ B` for columns of three numbers, without the loops of a matrix of general size.
fn transposed_product<const R: usize, const C: usize>(
    a: &SMatrix<f64, 3, R>,
    b: &SMatrix<f64, 3, C>,
) -> SMatrix<f64, R, C> {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    SMatrix::from_fn(|row, column| dot(&a.data.0[row], &b.data.0[column]))
}

/// Components of a vector along axes.
fn local(axes: &[Vector3<f64>; 3], vector: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(axes[0].dot(&vector), axes[1].dot(&vector), axes[2].dot(&vector))
}
