//! The wavelength of a string that snakes.
//!
//! A released string buckles in the wave that grows fastest, and keeps the number of its half
//! waves: each such state is stable, even where its waves are shorter than the best ones under its
//! load. Without friction a slow load leads to the state of least energy. It is found by stretching
//! the waves, so that there are fewer of them, as long as that releases energy.

use super::{
    cascade::warm_start, equations::Equations, equilibrium::Equilibrium, judge::energy_J,
    string_in_hole::Node,
};

/// Minimum number of half waves of a snake.
const LEAST_HALF_WAVES: usize = 6;

/// Minimum lateral amplitude of a half wave, as a part of the clearance.
const LEAST_AMPLITUDE: f64 = 0.05;

/// The first attempt removes the number of half waves over this.
const FIRST_ATTEMPT: usize = 16;

/// Maximum number of attempts.
const ATTEMPTS: usize = 24;

/// Returns the state of least energy by wavelength for a string without friction that snakes; any
/// other string unchanged.
pub(super) fn of_least_energy(mut found: Equilibrium, equations: &mut Equations) -> Equilibrium {
    if !found.convergence.stable || found.string.nodes.iter().any(Node::rubs) {
        return found;
    }
    let Some(mut snake) = Snake::of(&found) else { return found };
    let mut least_J = energy_J(&found.string, &found.state);
    let (mut by, mut longer) = (snake.first_attempt(), true);
    for _ in 0..ATTEMPTS {
        let own = snake.half_waves();
        let number = if longer { own.saturating_sub(by) } else { own + by };
        let mut iterations = found.convergence.iterations;
        let drawn = found.drawn(&snake.with_half_waves(number.max(1)));
        let next = warm_start(&found.string, drawn, equations, &mut iterations);
        let lower = next.filter(|(_, state)| energy_J(&found.string, state) < least_J);
        if let Some((convergence, state)) = lower {
            least_J = energy_J(&found.string, &state);
            let hook_load_N = equations.hook_load_N;
            found = Equilibrium { state, convergence, hook_load_N, ..found }.with_buckled_element();
            match Snake::of(&found) {
                Some(next) => snake = next,
                None => break,
            }
        } else if by > 1 {
            by /= 2;
        } else if longer {
            longer = false;
        } else {
            break;
        }
    }
    found
}

/// The half waves of a snake.
struct Snake {
    /// Distances from the bit at which the string crosses from side to side, m, from the bit up.
    crossings_m: Vec<f64>,
}

/// The snake with another number of half waves: the earlier position of each place of the string.
pub(super) struct Drawn {
    /// Distances from the bit, m, from the bit up: after, and before.
    places_m: Vec<[f64; 2]>,
    /// Whether the string above the snake is mirrored.
    mirrored: bool,
}

impl Snake {
    /// The longest snake of an equilibrium: consecutive half waves, each on the low side.
    fn of(solution: &Equilibrium) -> Option<Self> {
        let nodes = &solution.string.nodes;
        let mut longest: Vec<f64> = Vec::new();
        let mut crossings_m: Vec<f64> = Vec::new();
        let mut largest = 0.0_f64;
        let mut below: Option<(f64, f64)> = None;
        let mut end = |crossings_m: &mut Vec<f64>| {
            let own = std::mem::take(crossings_m);
            if own.len() > longest.len() {
                longest = own;
            }
        };
        for (index, node) in nodes.iter().enumerate().rev() {
            let from_bit_m = solution.mesh.nodes[index].from_bit_m;
            let [low, side] = towards(node, solution, index);
            // A helix, and a node off the wall or on the high side, ends a snake.
            if !node.has_wall() || low < 0.0 {
                end(&mut crossings_m);
                (largest, below) = (0.0, None);
                continue;
            }
            if let Some((at_m, before)) = below
                && (before > 0.0) != (side > 0.0)
            {
                if largest < LEAST_AMPLITUDE {
                    end(&mut crossings_m);
                }
                crossings_m.push(at_m + (from_bit_m - at_m) * before / (before - side));
                largest = 0.0;
            }
            largest = largest.max(side.abs());
            below = Some((from_bit_m, side));
        }
        end(&mut crossings_m);
        (longest.len() > LEAST_HALF_WAVES).then_some(Self { crossings_m: longest })
    }

    /// Number of its half waves.
    fn half_waves(&self) -> usize {
        self.crossings_m.len() - 1
    }

    /// Number of half waves that the first attempt removes.
    fn first_attempt(&self) -> usize {
        (self.half_waves() / FIRST_ATTEMPT).max(1)
    }

    /// The same stretch of string with another number of half waves.
    fn with_half_waves(&self, number: usize) -> Drawn {
        let own = self.half_waves();
        let last = self.crossings_m.len() - 1;
        let steps = 8 * number;
        let places_m = (0..=steps).map(|step| {
            let part = step as f64 / steps as f64;
            let at = |phase: f64| {
                let below = (phase as usize).min(last - 1);
                let [low_m, high_m] = [self.crossings_m[below], self.crossings_m[below + 1]];
                low_m + (high_m - low_m) * (phase - below as f64)
            };
            // Long waves stay long next to short ones: the length of each is that of those before.
            let after_m =
                self.crossings_m[0] + (self.crossings_m[last] - self.crossings_m[0]) * part;
            [after_m, at(self.phase(after_m) * number as f64 / own as f64)]
        });
        Drawn { places_m: places_m.collect(), mirrored: number % 2 != own % 2 }
    }

    /// Number of half waves below a place, m from the bit.
    fn phase(&self, from_bit_m: f64) -> f64 {
        let last = self.crossings_m.len() - 1;
        let above = self.crossings_m.partition_point(|at_m| *at_m <= from_bit_m).clamp(1, last);
        let [low_m, high_m] = [self.crossings_m[above - 1], self.crossings_m[above]];
        (above - 1) as f64 + (from_bit_m - low_m) / (high_m - low_m)
    }
}

impl Drawn {
    /// Earlier position of a place of the string, m from the bit, its earlier length per metre, and
    /// the sign of its lateral offset.
    pub(super) fn before(&self, from_bit_m: f64) -> [f64; 3] {
        let last = self.places_m.len() - 1;
        let (lowest_m, highest_m) = (self.places_m[0][0], self.places_m[last][0]);
        if from_bit_m <= lowest_m {
            return [from_bit_m, 1.0, 1.0];
        }
        if from_bit_m >= highest_m {
            return [from_bit_m, 1.0, if self.mirrored { -1.0 } else { 1.0 }];
        }
        let above = self.places_m.partition_point(|at| at[0] <= from_bit_m).clamp(1, last);
        let ([a0, b0], [a1, b1]) = (self.places_m[above - 1], self.places_m[above]);
        let rate = (b1 - b0) / (a1 - a0);
        [b0 + (from_bit_m - a0) * rate, rate, 1.0]
    }
}

/// Offset of a node towards the low side and to the side of it, over its clearance.
fn towards(node: &Node, solution: &Equilibrium, index: usize) -> [f64; 2] {
    let [low, side] = node.low_and_side();
    let offset = solution.state.offset_m[index].xy() / node.clearance_m;
    [offset.dot(&low), offset.dot(&side)]
}
