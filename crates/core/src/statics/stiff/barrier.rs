//! Contact by minimising the energy with a barrier before the wall: slower than the interior point,
//! but it goes downhill, and so finds its way through buckling.
//!
//! ```text
//! E(u) − μ Σ ln g,      g = (c² − |u|²)/(2c),      μ → 0
//! ```
//!
//! Newton's steps on a matrix that is made positive definite where it is not, and a line search on
//! the energy. What rubs is a dead load, brought into line with the contact forces from one minimum
//! to the next.

use nalgebra::{Matrix2, Vector2, Vector3};

use super::{
    blocks::Entry,
    contact::Push,
    equations::Equations,
    interior_point::Iterated,
    state::{Round, State},
    string_in_hole::StringInHole,
};
use crate::{random::Random, rod::tangent::Ends};

/// Newton steps before it gives up.
const MOST: usize = 600;

/// Part of the way to the wall that a step may take.
const TO_THE_WALL: f64 = 0.995;

/// Farthest that a director turns in a step, rad.
const MOST_TURN: f64 = 0.2;

/// Farthest that a node goes round the axis in a step, rad.
const MOST_ROUND: f64 = 0.5;

/// Part of the expected gain that a step must have.
const ARMIJO: f64 = 1e-4;

/// Seeded disturbance, as a part of the room of each node: a straight string under too much
/// compression would stay so for ever.
const DISTURBANCE: f64 = 1e-3;

/// Disturbances that take the string off a saddle, at most, for each product of force and room.
const NUDGES: usize = 5;

/// Least room of a node, as a part of its clearance.
const LEAST_ROOM: f64 = 1e-13;

/// Newton steps that bring an element to its tension.
const CORRECTIONS: usize = 2;

/// Relaxation of the friction between minima.
const RELAXED: f64 = 0.7;

/// Friction below this part of the string's weight is none.
const NOTHING: f64 = 1e-3;

/// The energy of a string without torque, with friction as a dead load.
pub(super) struct Barrier<'a> {
    string: &'a StringInHole,
    pub(super) equations: &'a mut Equations,
    /// Friction on each node, N, in the hole's axes there.
    friction_N: Vec<Vector3<f64>>,
    walled: Vec<usize>,
    mean_clearance_m: f64,
}

impl<'a> Barrier<'a> {
    /// Without friction.
    pub(super) fn new(string: &'a StringInHole, equations: &'a mut Equations) -> Self {
        let walled: Vec<usize> =
            (0..string.nodes.len()).filter(|index| string.nodes[*index].has_wall()).collect();
        let sum: f64 = walled.iter().map(|index| string.nodes[*index].clearance_m).sum();
        Self {
            string,
            equations,
            friction_N: vec![Vector3::zeros(); string.nodes.len()],
            mean_clearance_m: sum / walled.len().max(1) as f64,
            walled,
        }
    }

    /// Moves every node by a little, never the same way.
    pub(super) fn disturb(&self, state: &mut State) {
        let mut random = Random::new(1);
        for index in &self.walled {
            let by = DISTURBANCE * self.room_m(state, *index);
            state.offset_m[*index].x += by * random.signed();
            state.offset_m[*index].y += by * random.signed();
        }
    }

    /// Moves every node off the wall to where the barrier of a product of force and room holds its
    /// contact force, along the hole as far as its tension asks for.
    fn withdraw(&self, state: &mut State, product: f64) {
        self.fit(state);
        for index in &self.walled {
            let clearance_m = self.string.nodes[*index].clearance_m;
            let room_m = product / state.normal_N[*index].max(f64::MIN_POSITIVE);
            // Of g = (c² − r²)/(2c).
            let free = (1.0 - 2.0 * room_m / clearance_m).clamp(0.25, 1.0 - LEAST_ROOM);
            let most_m = clearance_m * free.sqrt();
            let offset = &mut state.offset_m[*index];
            let by = (most_m / offset.xy().norm()).min(1.0);
            offset.x *= by;
            offset.y *= by;
        }
        self.stretch(state);
    }

    /// Moves the nodes along the hole until every element has its tension.
    fn stretch(&self, state: &mut State) {
        for (index, element) in self.string.elements.iter().enumerate() {
            let wanted_m = element.slack_m + state.tension_N[index] / element.stiffness.axial;
            let along = self.string.nodes[index + 1].axes[2];
            for _ in 0..CORRECTIONS {
                let ends = self.ends(state, index);
                let lacks_m = wanted_m - ends.longer_m(&element.stiffness);
                let cosine = ends.chord_m.normalize().dot(&along);
                state.offset_m[index + 1].z += lacks_m / cosine;
            }
        }
    }

    /// Tensions that fit the shape.
    fn fit(&self, state: &mut State) {
        for (index, element) in self.string.elements.iter().enumerate() {
            let ends = self.ends(state, index);
            let longer_m = ends.longer_m(&element.stiffness) - element.slack_m;
            state.tension_N[index] = element.stiffness.axial * longer_m;
        }
    }

    fn ends(&self, state: &State, index: usize) -> Ends {
        let directors = [
            self.string.elements[index].seen(&state.heading[index]),
            state.heading[index + 1].along,
        ];
        Ends { chord_m: state.chord_m(self.string, index), directors }
    }

    /// Room of a node, m.
    fn room_m(&self, state: &State, index: usize) -> f64 {
        let clearance_m = self.string.nodes[index].clearance_m;
        let offset = state.offset_m[index].xy();
        (clearance_m * clearance_m - offset.norm_squared()) / (2.0 * clearance_m)
    }

    /// Energy with the barrier, J; infinite beyond the wall.
    fn energy_J(&self, state: &State, product: f64) -> f64 {
        let mut sum = 0.0;
        for (index, of) in self.string.elements.iter().enumerate() {
            sum += self.ends(state, index).energy_J(&of.stiffness, of.slack_m);
        }
        for (index, node) in self.string.nodes.iter().enumerate() {
            let u = state.offset_m[index];
            sum -= node.load_N.dot(&state.moved_m(self.string, index))
                + self.friction_N[index].dot(&u);
            sum += 0.5 * node.hold_N_per_m * u.xy().norm_squared();
        }
        for index in &self.walled {
            let room_m = self.room_m(state, *index);
            if room_m <= LEAST_ROOM * self.string.nodes[*index].clearance_m {
                return f64::INFINITY;
            }
            sum -= product * room_m.ln();
        }
        sum
    }

    /// Minimises from one product of force and room to another, as parts of the mean weight of a
    /// node times its clearance. The room of every node is that of its place then.
    pub(super) fn minimise(&mut self, state: &mut State, range: [f64; 2]) -> Iterated {
        let found = self.descend(state, range);
        for index in &self.walled {
            state.slack_m[*index] = self.room_m(state, *index);
        }
        found
    }

    fn descend(&mut self, state: &mut State, range: [f64; 2]) -> Iterated {
        let mean_weight_N = self.string.weight_N() / self.string.nodes.len() as f64;
        let [first, last] = range.map(|part| part * mean_weight_N * self.mean_clearance_m);
        let mut product = first;
        self.withdraw(state, product);
        for index in &self.walled {
            state.normal_N[*index] = product / self.room_m(state, *index);
        }
        let (mut shift, mut nudges) = (0.0, 0);
        let string = self.string;
        let stiff_N_per_m = string.weight_N() / string.nodes.len() as f64 / self.mean_clearance_m;
        let length_m = string.elements.iter().map(|of| of.stiffness.length).sum::<f64>()
            / string.elements.len() as f64;
        for count in 1..=MOST {
            self.fit(state);
            self.equations.assemble(string, state, None);
            for (force, friction) in self.equations.force.iter_mut().zip(&self.friction_N).skip(1) {
                for row in 0..3 {
                    force[row] += friction[row];
                }
            }
            for at in 0..self.walled.len() {
                self.add_wall(state, self.walled[at], product);
            }
            let gradient = self.equations.force.clone();
            // Shifted until it is positive definite.
            let mut shifted = false;
            let step = loop {
                let mut step = gradient.clone();
                let turn = shift * length_m * length_m;
                let by = Entry::from_column_slice(&[shift, shift, shift, turn, turn]);
                if self.equations.matrix.solve_definite(&mut step, &by).is_some() {
                    break step;
                }
                shifted = true;
                shift = if shift == 0.0 { 1e-3 * stiff_N_per_m } else { 5.0 * shift };
                if !shift.is_finite() || shift > 1e12 * stiff_N_per_m {
                    return Iterated { count, converged: false };
                }
            };
            shifted |= shift > 0.0;
            shift = if shift < 1e-4 * stiff_N_per_m { 0.0 } else { shift / 3.0 };
            let slope: f64 = gradient.iter().zip(&step).map(|(force, by)| force.dot(by)).sum();
            let (part, gained) = self.search(state, &step, slope, product);
            if gained {
                self.take(state, &step, part, product);
            }
            let small = slope < 1e-3 * product * self.walled.len().max(1) as f64;
            if (small || !gained) && shifted && nudges < NUDGES {
                // A saddle: anything takes it off.
                nudges += 1;
                self.disturb(state);
            } else if small || !gained {
                nudges = 0;
                if product <= last {
                    self.fit(state);
                    return Iterated { count, converged: true };
                }
                product = (0.1 * product).max(last);
            }
        }
        Iterated { count: MOST, converged: false }
    }

    /// The length of a step that the energy allows; whether there is any.
    fn search(&self, state: &State, step: &[Entry], slope: f64, product: f64) -> (f64, bool) {
        let mut part = 1.0_f64;
        for by in step {
            part = part.min(MOST_TURN / by[3].hypot(by[4]).max(f64::MIN_POSITIVE));
        }
        for index in &self.walled {
            let clearance_m = self.string.nodes[*index].clearance_m;
            let u = state.offset_m[*index].xy();
            if let Some(round) = Round::of(&u, &step[*index], clearance_m) {
                let to_go_m = clearance_m - u.norm();
                if round.outwards_m > 0.0 {
                    part = part.min(TO_THE_WALL * to_go_m / round.outwards_m);
                }
                part = part.min(MOST_ROUND / round.turn_rad.abs().max(f64::MIN_POSITIVE));
                continue;
            }
            let du = Vector2::new(step[*index][0], step[*index][1]);
            // |u + a du| = c.
            let (a, b) = (du.norm_squared(), u.dot(&du));
            let c = u.norm_squared() - clearance_m * clearance_m;
            if a > 0.0 {
                let root = (b * b - a * c).max(0.0).sqrt();
                let meets = if b > 0.0 { -c / (b + root) } else { (root - b) / a };
                part = part.min(TO_THE_WALL * meets);
            }
        }
        let before_J = self.energy_J(state, product);
        let rounding_J = 1e-12 * before_J.abs();
        for _ in 0..30 {
            let there = self.moved(state, step, part);
            if self.energy_J(&there, product) <= before_J - ARMIJO * part * slope + rounding_J {
                return (part, true);
            }
            part *= 0.5;
        }
        (part, false)
    }

    /// The state after a part of a step. Along the hole the nodes go as far as the tensions of the
    /// step ask for: a straight way would stretch what turns, and the valley between is narrow.
    fn moved(&self, state: &State, step: &[Entry], part: f64) -> State {
        let mut there = state.clone();
        there.advance_round(self.string, step, part);
        for (index, tension_N) in there.tension_N.iter_mut().enumerate() {
            *tension_N += part * self.equations.tension_step_N(index, step);
        }
        self.stretch(&mut there);
        there
    }

    /// Takes a part of a step; the contact forces follow.
    fn take(&self, state: &mut State, step: &[Entry], part: f64, product: f64) {
        for index in &self.walled {
            let node = &self.string.nodes[*index];
            let room_m = self.room_m(state, *index);
            let u = state.offset_m[*index].xy();
            let du = Vector2::new(step[*index][0], step[*index][1]);
            let steep = state.normal_N[*index] / room_m;
            let dn =
                product / room_m - state.normal_N[*index] + steep * u.dot(&du) / node.clearance_m;
            state.normal_N[*index] += part * dn;
        }
        *state = self.moved(state, step, part);
        for index in &self.walled {
            let primal_N = product / self.room_m(state, *index);
            state.normal_N[*index] =
                state.normal_N[*index].clamp(0.01 * primal_N, 100.0 * primal_N);
        }
    }

    /// Adds the wall of a node to the equations.
    fn add_wall(&mut self, state: &State, index: usize, product: f64) {
        let clearance_m = self.string.nodes[index].clearance_m;
        let room_m = self.room_m(state, index);
        let normal_N = state.normal_N[index];
        let towards = state.offset_m[index].xy() / clearance_m;
        let force = &mut self.equations.force[index];
        force[0] -= product / room_m * towards.x;
        force[1] -= product / room_m * towards.y;
        let across = Matrix2::identity() * (normal_N / clearance_m)
            + towards * towards.transpose() * (normal_N / room_m);
        let mut diagonal = self.equations.matrix.diagonal[index].fixed_view_mut::<2, 2>(0, 0);
        diagonal += across;
    }

    /// Brings friction into line with the contact forces; by how much of it it changed.
    pub(super) fn rub(&mut self, state: &State) -> f64 {
        let (mut changed, mut whole) = (0.0, 0.0);
        for index in &self.walled {
            let node = &self.string.nodes[*index];
            let offset = state.offset_m[*index].xy();
            let radius_m = offset.norm();
            let push = Push::exact(node, &(offset / radius_m.max(f64::MIN_POSITIVE)), radius_m);
            let normal = offset / radius_m.max(f64::MIN_POSITIVE);
            let rubs =
                (push.force + Vector3::new(normal.x, normal.y, 0.0)) * state.normal_N[*index];
            let change = rubs - self.friction_N[*index];
            self.friction_N[*index] += change * RELAXED;
            changed += change.norm();
            whole += rubs.norm();
        }
        changed / whole.max(NOTHING * self.string.weight_N())
    }
}
