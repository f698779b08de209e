//! Dynamic relaxation: the string is released in the middle of its hole, in a fluid so viscous that
//! it never swings. It sinks to the wall, buckles, rolls and reaches equilibrium, or does not.
//!
//! ```text
//! drag · du/dt = forces on the nodes across the hole,    all else in equilibrium
//! ```
//!
//! One step of Newton's method with the drag on its diagonal is a step of implicit Euler; the drag
//! falls as the string slows down, and the last steps are Newton's own: pseudo-transient
//! continuation (C. T. Kelley and D. E. Keyes, *Convergence analysis of pseudo-transient
//! continuation*, SIAM J. Numer. Anal. 35 (1998)). Friction and torque act from the
//! beginning, though they have no energy. Like the real string, this one leaves an unstable state:
//! the drag always exceeds the rate at which the steepest descent gains energy.

use nalgebra::Matrix2;

use super::{
    active_set::OnWall,
    blocks::Entry,
    contact,
    equations::Equations,
    judge,
    state::{Round, State},
    string_in_hole::StringInHole,
};
use crate::random::Random;

/// Maximum number of steps; that number times the elements, which limits the time of a failure; and
/// the smallest number that this may lead to. In hundreds of wells strings that reached equilibrium
/// took 210 steps at most, and 260 000 as steps times elements.
const MOST: usize = 400;
const MOST_OF_ELEMENTS: usize = 350_000;
const AT_LEAST: usize = 90;

/// Seeded disturbance, as a part of the gap of each node: without it a straight string under too
/// much compression would stay straight.
const DISTURBANCE: f64 = 1e-3;

/// Limits of a step: rotation of a node around the axis, rad, rotation of a director, rad, and
/// radial motion of a node, as a part of its clearance.
const MOST_ROUND: f64 = 0.5;
const MOST_TURN: f64 = 0.2;
const MOST_OUT: f64 = 0.5;

/// Initial drag, the smallest drag, and a drag under which nothing moves any more, over the
/// stiffness of the foundation by weight.
const FIRST: f64 = 1.0;
const LEAST: f64 = 1e-4;
const FROZEN: f64 = 1e9;

/// Factor of the drag where it is too small, as after a step of less than this part, ...
const MORE: f64 = 1.5;
const SHORT: f64 = 0.3;

/// ... and after a step at full length: with nodes that met the wall or left it, and without.
const LESS: [f64; 2] = [0.7, 0.3];

/// Number of consecutive steps at the smallest drag in which nodes meet the wall or leave it that
/// counts as a cycle, because every step is too long. The drag is then raised to the second value,
/// or by the third factor, and is no longer reduced while any node meets the wall or leaves it.
const CYCLE: usize = 20;
const CAREFUL: f64 = 1e-2;
const MORE_CAREFUL: f64 = 10.0;

/// Number of small increases of the drag after which it is checked whether any drag is sufficient.
const TRIES: usize = 8;

/// A string whose steps are shorter than this may be at rest, m. After a failed check the length is
/// multiplied by the factor; there are this many checks.
const STILL_M: f64 = 1e-4;
const STILLER: f64 = 1e-2;
pub(super) const LOOKS: usize = 3;

/// A string with a step longer than this has left its state, m.
const MOVES_M: f64 = 1e-2;

/// Angle around its hole beyond which a node is taken to roll without end, rad, and the angle that
/// is sufficient where the string did not reach equilibrium. In hundreds of wells strings that did
/// moved around by less than a turn.
const ROLLS: [f64; 2] = [3.0 * std::f64::consts::PI, 2.0 * std::f64::consts::PI];

/// Ratio to the largest compression of the soft string beyond which the compression of a string
/// that does not reach equilibrium is taken to run away.
const AWAY: f64 = 2.0;

/// Ratio to the largest compression of the soft string from which no string recovers, when the
/// compression has grown beyond it in this many consecutive steps: among the points of a plan of
/// 8.5 km those that reached equilibrium had 2.7 at most, pushed with 1.2 MN.
const LOST: f64 = 4.0;
const LOST_STEPS: usize = 5;

/// Compression by the soft string from which this is checked, as a part of the string's weight.
const PUSHED: f64 = 0.02;

/// Part of the wall friction that acts along the hole from which a string counts as sliding.
const SLIDES: f64 = 0.1;

/// A string whose compression exceeds the soft string's by this factor after its last step is given
/// twice as many, so that it reaches equilibrium or runs away.
const GROWING: f64 = 1.25;

/// Behaviour of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Does {
    /// It is at rest, or nearly so.
    Rests,
    /// It rolls around the hole by its friction: most at this node.
    Rolls(usize),
    /// Its compression grows beyond all bounds: most in this element.
    RunsAway(usize),
    /// It was still moving after the last step.
    Moves,
}

/// A released string.
pub(super) struct Relaxation<'a> {
    string: &'a StringInHole,
    pub(super) state: State,
    /// Drag over the stiffness of the foundation by weight.
    drag: f64,
    /// Number of consecutive steps in which contacts changed, and whether it was once too large.
    restless: usize,
    careful: bool,
    /// Angle of each node around the hole, rad.
    round_rad: Vec<f64>,
    /// Number of steps so far.
    pub(super) steps: usize,
    still_m: f64,
    /// Whether the string slides along the hole anywhere. One that rotates does not lock up:
    /// however hard the wall presses it, next to no axial friction holds back the push.
    slides: bool,
    /// Number of consecutive steps in which the compression has grown beyond [`LOST`], and the
    /// largest compression of the last step, N.
    lost_steps: usize,
    compression_N: f64,
}

/// Result of a step.
struct Stepped {
    longest_m: f64,
    whole: bool,
    /// Nodes that met the wall or left it.
    changed: usize,
    /// Whether the drag had to be raised to exceed the rate of every descent.
    slowed: bool,
}

impl<'a> Relaxation<'a> {
    /// Begins in the middle of the hole, with a small random offset.
    pub(super) fn begin(string: &'a StringInHole) -> Self {
        let mut state = State::centred(string);
        let mut random = Random::new(1);
        for (index, node) in string.nodes.iter().enumerate() {
            state.normal_N[index] = 0.0;
            if node.has_wall() {
                // In the middle the gap counts as half of the clearance.
                let by_m = 0.5 * DISTURBANCE * node.clearance_m;
                state.offset_m[index].x += by_m * random.signed();
                state.offset_m[index].y += by_m * random.signed();
            }
        }
        let round_rad = vec![0.0; string.nodes.len()];
        let slides = string.nodes.iter().any(|node| {
            let [along, around] = node.friction;
            along.abs() > SLIDES * libm::hypot(along, around)
        });
        Self {
            string,
            state,
            drag: FIRST,
            restless: 0,
            careful: false,
            round_rad,
            steps: 0,
            still_m: STILL_M,
            slides,
            lost_steps: 0,
            compression_N: 0.0,
        }
    }

    /// Continues until the string may be at rest, or never will be. Sets `moved` where the string
    /// has left the state in which it last counted as at rest.
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

    /// The node that moved farthest around the hole, if by more than an angle, rad.
    fn rolling(&self, angle_rad: f64) -> Option<usize> {
        let far = |index: &usize| self.round_rad[*index].abs();
        let most = (0..self.round_rad.len()).max_by(|a, b| far(a).total_cmp(&far(b)))?;
        (far(&most) > angle_rad).then_some(most)
    }

    /// The element under the largest compression of a string that slides, if that is far beyond the
    /// soft string's.
    fn running_away(&self) -> Option<usize> {
        self.is_beyond(AWAY).filter(|_| self.slides)
    }

    /// The same, if its compression has grown in several consecutive steps, so far that it will not
    /// recover.
    fn is_lost(&mut self) -> Option<usize> {
        let pushed_N =
            self.string.elements.iter().map(|element| -element.guess_N).fold(0.0, f64::max);
        // A string that hangs is pressed by its bends alone.
        let is_pushed = pushed_N > PUSHED * self.string.weight_N();
        let found = self.is_beyond(LOST).filter(|_| is_pushed && self.slides);
        let before_N = self.compression_N;
        self.compression_N = found.map_or(0.0, |element| -self.state.tension_N[element]);
        let grows = found.is_some() && self.compression_N > before_N;
        self.lost_steps = if grows { self.lost_steps + 1 } else { 0 };
        found.filter(|_| self.lost_steps >= LOST_STEPS)
    }

    /// The element under the largest compression, if that exceeds the soft string's by this factor.
    fn is_beyond(&self, times: f64) -> Option<usize> {
        let least = |a: &f64, b: &f64| a.total_cmp(b);
        let tensions_N = self.state.tension_N.iter().enumerate();
        let (index, tension_N) = tensions_N.min_by(|a, b| least(a.1, b.1))?;
        let guesses_N = self.string.elements.iter().map(|element| element.guess_N);
        let guess_N = guesses_N.fold(0.0, f64::min);
        (*tension_N < times * guess_N).then_some(index)
    }

    /// Takes a step; none where there is no solution.
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

    /// Whether contacts changed in so many steps that they are in a cycle.
    fn cycles(&mut self, changed: usize) -> bool {
        let counts = changed > 0 && (self.careful || self.drag == LEAST);
        self.restless = if counts { self.restless + 1 } else { 0 };
        let cycles = self.restless == CYCLE;
        if cycles {
            (self.restless, self.careful) = (0, true);
        }
        cycles
    }

    /// Raises the drag until it exceeds the energy that any motion gains, friction apart. Returns
    /// whether it had to be raised; none where there is no such drag.
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

/// Adds the stiffness of the walls at the nodes, times a sign, to the equations.
fn lean(equations: &mut Equations, walls: &[Option<Matrix2<f64>>], sign: f64) {
    for (diagonal, wall) in equations.matrix.diagonal.iter_mut().zip(walls) {
        if let Some(wall_N_per_m) = wall {
            let mut across = diagonal.fixed_view_mut::<2, 2>(0, 0);
            across += wall_N_per_m * sign;
        }
    }
}

/// The part of a step that exceeds no limit of rotation or radial motion.
fn part_of(string: &StringInHole, state: &State, step: &[Entry]) -> f64 {
    let mut part = 1.0_f64;
    let mut at_most =
        |most: f64, size: f64| part = part.min(most / size.abs().max(f64::MIN_POSITIVE));
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
