//! Transfer of a state from one string to another, with a finer mesh, another load or a somewhat
//! deeper bit.
//!
//! All quantities are transferred along the string, by the distance from the bit, in the hole's own
//! axes: those follow the hole without twisting, and so hardly depend on the mesh.

use nalgebra::{Vector2, Vector3};

use super::{
    director::Heading, equilibrium::Equilibrium, snake::Drawn, state::State,
    string_in_hole::StringInHole,
};
use crate::rod::mesh::Mesh;

/// Nodes nearer than this are the same, m.
const SAME_M: f64 = 1e-6;

impl Equilibrium {
    /// Returns an initial state of `string` with mesh `mesh`, interpolated from this one.
    pub(super) fn carried_to(&self, string: &StringInHole, mesh: &Mesh) -> State {
        let mut state = State::centred(string);
        for (index, node) in mesh.nodes.iter().enumerate() {
            let place = self.place(node.from_bit_m);
            let [across, slope] = self.shape(&place);
            let axes = &string.nodes[index].axes;
            state.offset_m[index] = across;
            let along = axes[0] * slope.x + axes[1] * slope.y + axes[2];
            state.heading[index] = Heading::new(along.normalize(), axes[0]);
            state.normal_N[index] = self.normal_N(&place, mesh, index);
            let clearance_m = string.nodes[index].clearance_m;
            state.slack_m[index] = clearance_m - across.xy().norm();
        }
        for (index, element) in string.elements.iter().enumerate() {
            let middle_m = 0.5 * (mesh.nodes[index].from_bit_m + mesh.nodes[index + 1].from_bit_m);
            let own = self.place(middle_m).element;
            state.tension_N[index] =
                element.guess_N + self.state.tension_N[own] - self.string.elements[own].guess_N;
        }
        state
    }

    /// Returns its own state with its waves stretched.
    pub(super) fn drawn(&self, drawn: &Drawn) -> State {
        let mut state = self.state.clone();
        for (index, node) in self.mesh.nodes.iter().enumerate() {
            let [from_bit_m, rate, sign] = drawn.before(node.from_bit_m);
            if (from_bit_m, sign) == (node.from_bit_m, 1.0) {
                continue;
            }
            let place = self.place(from_bit_m);
            let [across, slope] = self.shape(&place);
            let there = &self.string.nodes[place.element].low_and_side();
            let own = &self.string.nodes[index];
            let here = own.low_and_side();
            let turned = |vector: Vector2<f64>, scale: f64| {
                (here[0] * there[0].dot(&vector) + here[1] * (sign * there[1].dot(&vector))) * scale
            };
            let (offset, slope) = (turned(across.xy(), 1.0), turned(slope.xy(), rate));
            state.offset_m[index].x = offset.x;
            state.offset_m[index].y = offset.y;
            let along = own.axes[0] * slope.x + own.axes[1] * slope.y + own.axes[2];
            state.heading[index] = Heading::new(along.normalize(), own.axes[0]);
            state.normal_N[index] = self.normal_N(&place, &self.mesh, index);
            state.slack_m[index] = own.clearance_m - offset.norm();
        }
        state
    }

    /// The element at a distance from the bit, m, and the part of it above that distance.
    fn place(&self, from_bit_m: f64) -> Place {
        let nodes = &self.mesh.nodes;
        // The distances decrease along the nodes.
        let below = nodes.partition_point(|node| node.from_bit_m > from_bit_m - SAME_M);
        let element = below.saturating_sub(1).min(nodes.len() - 2);
        let (upper_m, lower_m) = (nodes[element].from_bit_m, nodes[element + 1].from_bit_m);
        Place { element, part: ((upper_m - from_bit_m) / (upper_m - lower_m)).clamp(0.0, 1.0) }
    }

    /// Penetration of an element's body into the wall between its nodes, m: its excess over its
    /// clearance and over the offsets of both nodes, by the cubic between them at its quarter
    /// points.
    pub(super) fn bulges_m(&self, element: usize) -> f64 {
        let ends = [element, element + 1].map(|node| self.state.offset_m[node].xy().norm());
        let inside_m = self.string.elements[element].body_clearance_m.max(ends[0]).max(ends[1]);
        let off_m = |part: f64| self.shape(&Place { element, part })[0].xy().norm();
        [0.25, 0.5, 0.75].into_iter().map(off_m).fold(0.0, f64::max) - inside_m
    }

    /// Offset, m, and slope across the hole per length along it, by the cubic between the nodes.
    fn shape(&self, place: &Place) -> [Vector3<f64>; 2] {
        let Place { element, part: t } = *place;
        let length_m = self.mesh.elements[element].length_m;
        let [u1, u2] = [element, element + 1].map(|node| self.state.offset_m[node]);
        let seen = self.string.elements[element].seen(&self.state.heading[element]);
        let own = |node: usize| self.slope(node, self.state.heading[node].along);
        let [m1, m2] = [self.slope(element, seen), own(element + 1)].map(|m| m * length_m);
        let (t2, t3) = (t * t, t * t * t);
        let across = u1.xy() * (2.0 * t3 - 3.0 * t2 + 1.0)
            + m1 * (t3 - 2.0 * t2 + t)
            + u2.xy() * (3.0 * t2 - 2.0 * t3)
            + m2 * (t3 - t2);
        let rises = (u2.xy() - u1.xy()) * (6.0 * (t - t2))
            + m1 * (3.0 * t2 - 4.0 * t + 1.0)
            + m2 * (3.0 * t2 - 2.0 * t);
        // A bend is below its node: the director is that of the body above.
        let slope = if t == 0.0 { own(element) } else { rises / length_m };
        let along = u1.z + (u2.z - u1.z) * t;
        [Vector3::new(across.x, across.y, along), Vector3::new(slope.x, slope.y, 0.0)]
    }

    /// Slope of a director at a node: its components across the hole over that along it.
    fn slope(&self, node: usize, director: Vector3<f64>) -> Vector2<f64> {
        let [e1, e2, along] = &self.string.nodes[node].axes;
        Vector2::new(director.dot(e1), director.dot(e2)) / director.dot(along)
    }

    /// Contact force of a node of another mesh, N, from those of this one.
    fn normal_N(&self, place: &Place, mesh: &Mesh, index: usize) -> f64 {
        let own_m = mesh.tributary_length_m(index);
        let at = |node: usize| {
            let force_N = self.state.normal_N[node];
            // Continuous contact has a force per length, a joint a force of its own.
            let adjacent = [node.checked_sub(1), Some(node + 1)].into_iter().flatten();
            let lies = adjacent
                .filter_map(|other| self.state.normal_N.get(other))
                .any(|other_N| *other_N > 0.0);
            if lies { force_N * own_m / self.mesh.tributary_length_m(node) } else { force_N }
        };
        let Place { element, part } = *place;
        if part == 0.0 {
            return at(element);
        }
        if part == 1.0 {
            return at(element + 1);
        }
        let ends = [element, element + 1].map(at);
        if ends[0] > 0.0 && ends[1] > 0.0 { ends[0] + (ends[1] - ends[0]) * part } else { 0.0 }
    }
}

/// An element and the part of it that is above a place.
struct Place {
    element: usize,
    part: f64,
}
