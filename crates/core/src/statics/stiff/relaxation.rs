//! The string let go in the middle of its hole, in a fluid so thick that it never swings: it sinks
//! to the wall, buckles, rolls and comes to rest, or does not.
//!
//! ```text
//! drag · du/dt = forces on the nodes across the hole,    all else in balance
//! ```
//!
//! One step of Newton's method with the drag on its diagonal is a step of implicit Euler; the drag
//! falls as the string slows down, and the last steps are Newton's own: pseudo-transient
//! continuation (C. T. Kelley and D. E. Keyes, *Convergence analysis of pseudo-transient
//! continuation*, SIAM J. Numer. Anal. 35 (1998)). Friction and torque are there from the
//! beginning, energy or not. As the real string does, this one leaves a state that would not stay:
//! the drag is always more than what the steepest way down takes.

use nalgebra::Matrix2;

use super::{
    blocks::Entry,
    contact,
    equations::Equations,
    judge,
    on_wall::OnWall,
    state::{Round, State},
    string_in_hole::StringInHole,
};
use crate::random::Random;

/// Steps before it gives up: so many, fewer of a string with many elements, that a refusal does not
/// take for ever, but no fewer than that. What comes to rest took 210 at most, and 260 000 times its
/// elements, in hundreds of wells.
const MOST: usize = 400;
const MOST_OF_ELEMENTS: usize = 350_000;
const AT_LEAST: usize = 90;

/// Seeded disturbance, as a part of the room of each node: a straight string under too much
/// compression would stay so for ever.
const DISTURBANCE: f64 = 1e-3;

/// Farthest that a node goes round the axis in a step, rad, that a director turns, and that a node
/// goes in or out, as a part of its clearance.
const MOST_ROUND: f64 = 0.5;
const MOST_TURN: f64 = 0.2;
const MOST_OUT: f64 = 0.5;

/// First drag, the least, and one under which nothing moves any more, over the foundation that the
/// weight is.
const FIRST: f64 = 1.0;
const LEAST: f64 = 1e-4;
const FROZEN: f64 = 1e9;

/// What the drag is multiplied by where it is too little, as after a step of less than this part,
/// ...
const MORE: f64 = 1.5;
const SHORT: f64 = 0.3;

/// ... and after a step at full length: with nodes that met the wall or left it, and without.
const LESS: [f64; 2] = [0.7, 0.3];

/// So many steps in a row in which nodes meet the wall or leave it, at the least drag, are a cycle:
/// every step goes too far. The drag is raised to this then, or to so many times what it is, and
/// falls no more while any node does.
const CYCLE: usize = 20;
const CAREFUL: f64 = 1e-2;
const MORE_CAREFUL: f64 = 10.0;

/// So many times the drag is raised by little before it is asked whether any would do.
const TRIES: usize = 8;

/// A string whose steps are shorter may be at rest, m; after a look in vain, this part of it, so
/// often.
const STILL_M: f64 = 1e-4;
const STILLER: f64 = 1e-2;
pub(super) const LOOKS: usize = 3;

/// A string whose steps are longer has left where it was, m.
const MOVES_M: f64 = 1e-2;

/// A node that went round its hole by so much, rad, goes on; by so much it may, where the string
/// did not come to rest. What does rest went round by less than a turn in hundreds of wells.
const ROLLS: [f64; 2] = [3.0 * std::f64::consts::PI, 2.0 * std::f64::consts::PI];

/// Compression that runs away, over the largest of the soft string, where the string does not come to
/// rest.
const AWAY: f64 = 2.0;

/// Compression over the largest of the soft string that no string comes back from, when it has grown
/// beyond it from step to step for so long: of the points of a plan of 8.5 km those that came to rest
/// had 2.7 at most, pushed with 1.2 MN.
const LOST: f64 = 4.0;
const LOST_STEPS: usize = 5;

/// Compression by the soft string from which that is looked at, as a part of the string's weight.
const PUSHED: f64 = 0.02;

/// A string whose compression is beyond the soft string's by this factor when its steps are used up
/// gets twice as many: it comes to rest, or is seen to run away.
const GROWING: f64 = 1.25;

/// What the string does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Does {
    /// It lies still, or nearly so.
    Rests,
    /// Turned by its friction, it rolls around the hole: most at this node.
    Rolls(usize),
    /// Its compression grows beyond all bounds: most in this element.
    RunsAway(usize),
    /// It went on moving for as long as was looked at.
    Moves,
}

/// A string that sinks.
pub(super) struct Relaxation<'a> {
    string: &'a StringInHole,
    pub(super) state: State,
    /// Over the foundation that the weight is.
    drag: f64,
    /// Steps in a row in which contacts changed, and whether they went on for too long once.
    restless: usize,
    careful: bool,
    /// How far each node went round, rad.
    round_rad: Vec<f64>,
    /// Steps so far.
    pub(super) steps: usize,
    still_m: f64,
    /// Steps in a row in which the compression has grown beyond [`LOST`], and the largest of the
    /// last step, N.
    lost_steps: usize,
    compression_N: f64,
}

/// What a step came to.
struct Stepped {
    longest_m: f64,
    whole: bool,
    /// Nodes that met the wall or left it.
    changed: usize,
    /// Whether less drag would have let it go down faster than any motion does.
    slowed: bool,
}

impl<'a> Relaxation<'a> {
    /// In the middle of the hole, but for a little that is never the same way.
    pub(super) fn begin(string: &'a StringInHole) -> Self {
        let mut state = State::centred(string);
        let mut random = Random::new(1);
        for (index, node) in string.nodes.iter().enumerate() {
            state.normal_N[index] = 0.0;
            if node.has_wall() {
                // Half of the clearance is the room that the middle counts as.
                let by_m = 0.5 * DISTURBANCE * node.clearance_m;
                state.offset_m[index].x += by_m * random.signed();
                state.offset_m[index].y += by_m * random.signed();
            }
        }
        let round_rad = vec![0.0; string.nodes.len()];
        Self {
            string,
            state,
            drag: FIRST,
            restless: 0,
            careful: false,
            round_rad,
            steps: 0,
            still_m: STILL_M,
            lost_steps: 0,
            compression_N: 0.0,
        }
    }

    /// Goes on until it may be at rest, or never will be. `moved` is told where the string has left
    /// the state that it was in when it was last said to rest.
    pub(super) fn go_on(&mut self, equations: &mut Equations, moved: &mut bool) -> Does {
        let turns = self.string.nodes.iter().any(|node| node.friction[1] != 0.0);
        let most = MOST.min(MOST_OF_ELEMENTS / self.string.elements.len()).max(AT_LEAST);
        while self.steps < most || self.steps < 2 * most && self.is_beyond(GROWING).is_some() {
            self.steps += 1;
            let Some(stepped) = self.step(equations) else {
                return self.running_away().map_or(Does::Moves, Does::RunsAway);
            };
            *moved |= stepped.longest_m > MOVES_M;
            if let Some(element) = self.is_lost() {
                return Does::RunsAway(element);
            }
            if turns && let Some(node) = self.rolling(ROLLS[0]) {
                return Does::Rolls(node);
            }
            let slow = stepped.slowed || self.drag == LEAST;
            if slow && stepped.whole && stepped.changed == 0 && stepped.longest_m < self.still_m {
                self.still_m *= STILLER;
                return Does::Rests;
            }
        }
        let rolling = if turns { self.rolling(ROLLS[1]) } else { None };
        let away = || self.running_away().map_or(Does::Moves, Does::RunsAway);
        rolling.map_or_else(away, Does::Rolls)
    }

    /// The node that went round the hole farthest, if it is farther than an angle, rad.
    fn rolling(&self, angle_rad: f64) -> Option<usize> {
        let far = |index: &usize| self.round_rad[*index].abs();
        let most = (0..self.round_rad.len()).max_by(|a, b| far(a).total_cmp(&far(b)))?;
        (far(&most) > angle_rad).then_some(most)
    }

    /// The element under the largest compression, if that is far beyond what the soft string has.
    fn running_away(&self) -> Option<usize> {
        self.is_beyond(AWAY)
    }

    /// The same, if its compression has grown without a pause for some steps, so far that it will not
    /// come back.
    fn is_lost(&mut self) -> Option<usize> {
        let pushed_N = self.string.elements.iter().map(|of| -of.guess_N).fold(0.0, f64::max);
        // A string that hangs is pressed by its bends alone.
        let is_pushed = pushed_N > PUSHED * self.string.weight_N();
        let found = self.is_beyond(LOST).filter(|_| is_pushed);
        let before_N = self.compression_N;
        self.compression_N = found.map_or(0.0, |element| -self.state.tension_N[element]);
        let grows = found.is_some() && self.compression_N > before_N;
        self.lost_steps = if grows { self.lost_steps + 1 } else { 0 };
        found.filter(|_| self.lost_steps >= LOST_STEPS)
    }

    /// The element under the largest compression, if that is so many times what the soft string has.
    fn is_beyond(&self, times: f64) -> Option<usize> {
        let least = |a: &f64, b: &f64| a.total_cmp(b);
        let tensions_N = self.state.tension_N.iter().enumerate();
        let (index, tension_N) = tensions_N.min_by(|a, b| least(a.1, b.1))?;
        let guesses_N = self.string.elements.iter().map(|element| element.guess_N);
        let guess_N = guesses_N.fold(0.0, f64::min);
        (*tension_N < times * guess_N).then_some(index)
    }

    /// A step; none where it has none.
    fn step(&mut self, equations: &mut Equations) -> Option<Stepped> {
        let Self { string, state, .. } = self;
        let torques_N_m = contact::torques_N_m(string, &state.normal_N);
        equations.assemble(string, state, Some(&torques_N_m));
        let slowed = self.slow_down(equations)?;
        let Self { string, state, .. } = self;
        equations.shift_across(self.drag * string.foundation_N_per_m());
        let on_wall = OnWall::press(string, state, equations);
        equations.matrix.solve(&mut equations.force).ok()?;
        let step = &equations.force;
        let longest_m = step.iter().map(|by| libm::hypot(by[0], by[1])).fold(0.0, f64::max);
        if !step.iter().all(|by| by.iter().all(|part| part.is_finite())) {
            return None;
        }
        let part = part_of(string, state, step);
        for (index, node) in string.nodes.iter().enumerate() {
            let round = Round::of(&state.offset_m[index].xy(), &step[index], node.clearance_m);
            self.round_rad[index] += round.map_or(0.0, |round| part * round.turn_rad);
        }
        equations.stretch(state, part);
        state.advance_round(string, step, part);
        let changed = on_wall.follow(string, state, step, part);
        let whole = part == 1.0;
        if self.cycles(changed) {
            self.drag = (MORE_CAREFUL * self.drag).max(CAREFUL);
        } else if whole && !(self.careful && changed > 0) {
            self.drag = (LESS[usize::from(changed == 0)] * self.drag).max(LEAST);
        } else if part < SHORT {
            self.drag *= MORE;
        }
        Some(Stepped { longest_m, whole, changed, slowed })
    }

    /// Whether contacts changed in so many steps that they would go on doing so.
    fn cycles(&mut self, changed: usize) -> bool {
        let counts = changed > 0 && (self.careful || self.drag == LEAST);
        self.restless = if counts { self.restless + 1 } else { 0 };
        let cycles = self.restless == CYCLE;
        if cycles {
            (self.restless, self.careful) = (0, true);
        }
        cycles
    }

    /// Raises the drag until it is more than what any motion gains, friction apart, and says
    /// whether it had to; none where there is no such drag.
    fn slow_down(&mut self, equations: &mut Equations) -> Option<bool> {
        let string = self.string;
        let walls: Vec<Option<Matrix2<f64>>> = (0..string.nodes.len())
            .map(|index| judge::wall_N_per_m(&string.nodes[index], &self.state, index))
            .collect();
        lean(equations, &walls, 1.0);
        let before = self.drag;
        let foundation_N_per_m = string.foundation_N_per_m();
        let mut tries = 0;
        while !equations.is_definite(self.drag * foundation_N_per_m) {
            tries += 1;
            self.drag *= MORE;
            if tries == TRIES && !equations.is_definite(FROZEN * foundation_N_per_m) {
                return None;
            }
        }
        let raised = self.drag > before;
        if raised {
            self.drag *= MORE;
        }
        lean(equations, &walls, -1.0);
        Some(raised)
    }
}

/// Adds to the equations, times a sign, what the walls hold the nodes with.
fn lean(equations: &mut Equations, walls: &[Option<Matrix2<f64>>], sign: f64) {
    for (diagonal, wall) in equations.matrix.diagonal.iter_mut().zip(walls) {
        if let Some(wall_N_per_m) = wall {
            let mut across = diagonal.fixed_view_mut::<2, 2>(0, 0);
            across += wall_N_per_m * sign;
        }
    }
}

/// The part of a step that goes neither too far round nor in or out.
fn part_of(string: &StringInHole, state: &State, step: &[Entry]) -> f64 {
    let mut part = 1.0_f64;
    let mut at_most = |most: f64, of: f64| part = part.min(most / of.abs().max(f64::MIN_POSITIVE));
    for (index, node) in string.nodes.iter().enumerate() {
        let by = &step[index];
        at_most(MOST_TURN, libm::hypot(by[3], by[4]));
        if !node.has_wall() {
            continue;
        }
        let out_m = MOST_OUT * node.clearance_m;
        match Round::of(&state.offset_m[index].xy(), by, node.clearance_m) {
            Some(round) => {
                at_most(MOST_ROUND, round.turn_rad);
                at_most(out_m, round.outwards_m);
            }
            None => at_most(out_m, libm::hypot(by[0], by[1])),
        }
    }
    part
}
