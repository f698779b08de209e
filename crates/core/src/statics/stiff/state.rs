//! State of the string, which the iterations change.

use nalgebra::{Vector2, Vector3};

use super::{blocks::Entry, director::Heading, string_in_hole::StringInHole};

/// Initial contact force of a node off the wall in an interior point, as a part of the mean weight
/// of a node, and initial gap of a node on the wall, as a part of its clearance.
const SOME: f64 = 0.01;

/// A motion around the hole's axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Round {
    direction: Vector2<f64>,
    radius_m: f64,
    /// Motion of a whole step outwards, m, and around the axis, rad.
    pub(super) outwards_m: f64,
    pub(super) turn_rad: f64,
}

impl Round {
    /// Motion of a node, if it is off the axis by more than half of its clearance.
    pub(super) fn of(offset_m: &Vector2<f64>, step: &Entry, clearance_m: f64) -> Option<Self> {
        let radius_m = offset_m.norm();
        (radius_m > 0.5 * clearance_m).then(|| {
            let direction = offset_m / radius_m;
            let by = Vector2::new(step[0], step[1]);
            Self {
                direction,
                radius_m,
                outwards_m: direction.dot(&by),
                turn_rad: direction.perp(&by) / radius_m,
            }
        })
    }

    /// Offset after a part of the motion, m.
    fn after(&self, part: f64) -> Vector2<f64> {
        let (sine, cosine) = libm::sincos(part * self.turn_rad);
        let n = self.direction;
        Vector2::new(n.x * cosine - n.y * sine, n.x * sine + n.y * cosine)
            * (self.radius_m + part * self.outwards_m)
    }
}

/// Positions of the string's nodes, tensions and contact forces.
#[derive(Debug, Clone)]
pub(super) struct State {
    /// Displacements of the nodes from their anchors in the hole's axes there, m: two across, one
    /// along.
    pub(super) offset_m: Vec<Vector3<f64>>,
    /// Directors.
    pub(super) heading: Vec<Heading>,
    /// Effective tension of the elements, N.
    pub(super) tension_N: Vec<f64>,
    /// Contact force of the nodes, N.
    pub(super) normal_N: Vec<f64>,
    /// Remaining gap between the nodes and the wall, m: a separate variable of the interior point.
    pub(super) slack_m: Vec<f64>,
}

impl State {
    /// State on the hole's axis, with the tension by which the rest lengths were chosen, and half
    /// of the clearance as the gap.
    pub(super) fn centred(string: &StringInHole) -> Self {
        let nodes = &string.nodes;
        Self {
            offset_m: vec![Vector3::zeros(); nodes.len()],
            heading: nodes.iter().map(|node| Heading::new(node.axes[2], node.axes[0])).collect(),
            tension_N: string.elements.iter().map(|element| element.guess_N).collect(),
            normal_N: nodes.iter().map(|node| node.guess_N).collect(),
            slack_m: nodes.iter().map(|node| 0.5 * node.clearance_m).collect(),
        }
    }

    /// Gives every node a gap and a contact force, with which an interior point can begin.
    pub(super) fn leave_the_wall(&mut self, string: &StringInHole) {
        let weight_N = string.weight_N() / string.nodes.len() as f64;
        for (index, node) in string.nodes.iter().enumerate().filter(|(_, node)| node.has_wall()) {
            let normal_N = &mut self.normal_N[index];
            *normal_N = normal_N.max(SOME * weight_N);
            let slack_m = &mut self.slack_m[index];
            *slack_m = slack_m.max(SOME * node.clearance_m);
        }
    }

    /// Displacement of a node from its place on the hole's axis, m.
    pub(super) fn moved_m(&self, string: &StringInHole, index: usize) -> Vector3<f64> {
        let axes = &string.nodes[index].axes;
        let u = &self.offset_m[index];
        axes[0] * u.x + axes[1] * u.y + axes[2] * u.z
    }

    /// Vector from a node to the next, m. The difference of two positions in the well would have
    /// the rounding error of kilometres, by which short elements would be unbalanced.
    pub(super) fn chord_m(&self, string: &StringInHole, index: usize) -> Vector3<f64> {
        let [upper, lower] = [index, index + 1].map(|node| self.moved_m(string, node));
        string.elements[index].anchor_chord_m + (lower - upper)
    }

    /// Moves the nodes by a part of a step.
    pub(super) fn advance(&mut self, step: &[Entry], part: f64) {
        for ((offset, heading), by) in self.offset_m.iter_mut().zip(&mut self.heading).zip(step) {
            *offset += Vector3::new(by[0], by[1], by[2]) * part;
            *heading = heading.turned([by[3] * part, by[4] * part]);
        }
    }

    /// The same, but nodes farther from the axis than half their clearance move around it, because
    /// a straight motion along the wall would soon leave the hole.
    pub(super) fn advance_round(&mut self, string: &StringInHole, step: &[Entry], part: f64) {
        let before: Vec<Vector2<f64>> = self.offset_m.iter().map(|offset| offset.xy()).collect();
        self.advance(step, part);
        for (index, node) in string.nodes.iter().enumerate() {
            let round = Round::of(&before[index], &step[index], node.clearance_m);
            if let Some(round) = round {
                let offset = round.after(part);
                self.offset_m[index].x = offset.x;
                self.offset_m[index].y = offset.y;
            }
        }
    }
}
