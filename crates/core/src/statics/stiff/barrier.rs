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
    blocks::{Entry, UNKNOWNS},
    contact::Push,
    equations::Equations,
    interior_point::Iterated,
    state::State,
    string_in_hole::StringInHole,
};
use crate::{
    random::Random,
    rod::{element, tangent::Ends},
};

/// Newton steps before it gives up.
const MOST: usize = 1500;

/// Part of the way to the wall that a step may take.
const TO_THE_WALL: f64 = 0.995;

/// Farthest that a director turns in a step, rad.
const MOST_TURN: f64 = 0.2;

/// Part of the expected gain that a step must have.
const ARMIJO: f64 = 1e-4;

/// Seeded disturbance of the start, as a part of the clearance: a straight string under too much
/// compression would stay so for ever.
const DISTURBANCE: f64 = 1e-3;

/// Last product of force and room, as a part of the mean weight of a node times its clearance.
const LAST: f64 = 1e-5;

/// Relaxation of the friction between minima.
const RELAXED: f64 = 0.7;

/// Rounds of friction.
const ROUNDS: usize = 40;

/// Friction is settled when it changes by no more of its sum than this.
const SETTLED: f64 = 1e-4;

/// Minimises the energy of the string without torque, friction brought into line with contact.
pub(super) fn iterate(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
) -> Iterated {
    let mut barrier = Barrier::new(string, equations);
    barrier.disturb(state);
    let mean = string.weight_N() / string.nodes.len() as f64 * barrier.mean_clearance_m;
    let mut first = mean;
    let mut count = 0;
    for _ in 0..ROUNDS {
        let done = barrier.minimise(state, [first, LAST * mean], MOST - count);
        count += done.count;
        if !done.converged || count >= MOST {
            return Iterated { count, converged: false };
        }
        if barrier.rub(state) < SETTLED {
            return Iterated { count, converged: true };
        }
        first = 1e-2 * mean;
    }
    Iterated { count, converged: false }
}

struct Barrier<'a> {
    string: &'a StringInHole,
    equations: &'a mut Equations,
    /// Friction on each node, N, in the hole's axes there.
    friction_N: Vec<Vector3<f64>>,
    walled: Vec<usize>,
    mean_clearance_m: f64,
}

impl<'a> Barrier<'a> {
    fn new(string: &'a StringInHole, equations: &'a mut Equations) -> Self {
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

    /// Moves every node off the axis by a little, never the same way.
    fn disturb(&self, state: &mut State) {
        let mut random = Random::new(1);
        for index in &self.walled {
            let by = DISTURBANCE * self.string.nodes[*index].clearance_m;
            state.offset_m[*index].x += by * random.signed();
            state.offset_m[*index].y += by * random.signed();
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
        let [upper, lower] =
            [index, index + 1].map(|node| state.position_m(self.string, node));
        let directors = [
            self.string.elements[index].seen(&state.heading[index]),
            state.heading[index + 1].along,
        ];
        Ends { chord_m: lower - upper, directors }
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
            let k = &of.stiffness;
            let ends = self.ends(state, index);
            let longer_m = ends.longer_m(k);
            let strained_m = longer_m - of.slack_m;
            sum += element::energy(k, &ends.pose())
                + 0.5 * k.axial * (strained_m * strained_m - longer_m * longer_m);
        }
        for (index, node) in self.string.nodes.iter().enumerate() {
            let u = state.offset_m[index];
            let moved = node.axes[0] * u.x + node.axes[1] * u.y + node.axes[2] * u.z;
            sum -= node.load_N.dot(&moved) + self.friction_N[index].dot(&u);
            sum += 0.5 * node.hold_N_per_m * u.xy().norm_squared();
        }
        for index in &self.walled {
            let room_m = self.room_m(state, *index);
            if room_m <= 0.0 {
                return f64::INFINITY;
            }
            sum -= product * room_m.ln();
        }
        sum
    }

    /// Minimises from one product of force and room to another.
    fn minimise(&mut self, state: &mut State, [first, last]: [f64; 2], most: usize) -> Iterated {
        let mut product = first;
        for index in &self.walled {
            state.normal_N[*index] = product / self.room_m(state, *index);
        }
        let mut shift = 0.0;
        let string = self.string;
        let stiff_N_per_m =
            string.weight_N() / string.nodes.len() as f64 / self.mean_clearance_m;
        let length_m = string.elements.iter().map(|of| of.stiffness.length).sum::<f64>()
            / string.elements.len() as f64;
        for count in 1..=most {
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
            let step = loop {
                let mut step = gradient.clone();
                let turn = shift * length_m * length_m;
                let by = Entry::from_column_slice(&[shift, shift, shift, turn, turn]);
                if self.equations.matrix.solve_definite(&mut step, &by).is_some() {
                    break step;
                }
                shift = if shift == 0.0 { 1e-3 * stiff_N_per_m } else { 5.0 * shift };
                if !shift.is_finite() || shift > 1e12 * stiff_N_per_m {
                    return Iterated { count, converged: false };
                }
            };
            shift = if shift < 1e-6 * stiff_N_per_m { 0.0 } else { shift / 3.0 };
            let slope: f64 = gradient.iter().zip(&step).map(|(force, by)| force.dot(by)).sum();
            let (part, gained) = self.search(state, &step, slope, product);
            if super::interior_point::trace() && count % 10 == 1 {
                eprintln!("barrier {count} mu {product:.2e} slope {slope:.2e} part {part:.2e} shift {shift:.2e} gained {gained}");
            }
            if gained {
                self.take(state, &step, part, product);
            }
            let small = slope < 1e-3 * product * self.walled.len().max(1) as f64;
            if small || !gained {
                if product <= last {
                    self.fit(state);
                    return Iterated { count, converged: true };
                }
                product = (0.1 * product).max(last);
            }
        }
        Iterated { count: most, converged: false }
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
            let mut there = state.clone();
            there.advance(step, part);
            if self.energy_J(&there, product) <= before_J - ARMIJO * part * slope + rounding_J {
                return (part, true);
            }
            part *= 0.5;
        }
        (part, false)
    }

    /// Takes a part of a step; the contact forces follow.
    fn take(&self, state: &mut State, step: &[Entry], part: f64, product: f64) {
        for index in &self.walled {
            let node = &self.string.nodes[*index];
            let room_m = self.room_m(state, *index);
            let u = state.offset_m[*index].xy();
            let du = Vector2::new(step[*index][0], step[*index][1]);
            let steep = state.normal_N[*index] / room_m;
            let dn = product / room_m - state.normal_N[*index] + steep * u.dot(&du) / node.clearance_m;
            state.normal_N[*index] += part * dn;
        }
        state.advance(step, part);
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
        debug_assert!(UNKNOWNS >= 2);
    }

    /// Brings friction into line with the contact forces; by how much of it it changed.
    fn rub(&mut self, state: &State) -> f64 {
        let (mut changed, mut whole) = (0.0, 0.0);
        for index in &self.walled {
            let node = &self.string.nodes[*index];
            let offset = state.offset_m[*index].xy();
            let radius_m = offset.norm();
            let push = Push::exact(node, &(offset / radius_m.max(f64::MIN_POSITIVE)), radius_m);
            let normal = offset / radius_m.max(f64::MIN_POSITIVE);
            let rubs = (push.force + Vector3::new(normal.x, normal.y, 0.0)) * state.normal_N[*index];
            let change = rubs - self.friction_N[*index];
            self.friction_N[*index] += change * RELAXED;
            changed += change.norm();
            whole += rubs.norm();
        }
        if whole > 0.0 { changed / whole } else { 0.0 }
    }
}
