//! One step of the chain, or of a region of it: the inner loop of everything.
//!
//! Leapfrog (central differences): forces at the present positions kick the velocities across the
//! step, the velocities carry the positions on. Contact and friction act within the step,
//! implicitly at each node, so that they never limit it. One pass does both: a row of elements is
//! evaluated from positions that no node has left yet, and the row of nodes above it is moved,
//! while all of it is still in the first-level cache.
//!
//! A row is worked on in short loops, and the loops of the elements alternate with those of the
//! nodes, because neither depends on the other. The latency of one register of lanes (a root or a
//! division takes twenty cycles) is then hidden behind the others; in one long loop the processor
//! does not see far enough ahead. Where roots and divisions follow one another, two registers are
//! processed alternately.
//!
//! Directors move on the sphere by Cayley's rotation, which keeps their length and the right angle
//! to their angular velocity to rounding.

mod damping;
mod elements;
mod imbalance;
mod lane;
mod nodes;
mod scratch;

use elements::{Pull, Strains, bend, chord, strain, twist};
use imbalance::{follow, throw};
use lane::{Losses, lanes};
use nodes::{correct, friction, gap, normal_contact, predict, rotate_directors};
use scratch::Scratch;

use super::{
    border::Coupled,
    chain::{Chain, ElementBlock, RegionRows, Row, StateBlock},
};
use crate::simd::{
    counted::{self, Counted, Flops},
    dispatch::{available_instruction_sets, for_each_instruction_set},
    number::{Number, Real},
    peak,
    wide::{Pair, Registers},
};
pub use damping::MassDamping;
pub use lane::{StepInput, StepLosses};

/// Laws of contact. They are selected once per row of nodes: separate code for each would quadruple
/// the compile time without a faster step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Laws {
    /// Hertz contact, not the linear one.
    pub hertz: bool,
    /// Vector friction, not the independent one.
    pub vector: bool,
}

/// Required features of the stepper; fewer are faster.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Abilities {
    /// Laws of contact.
    pub laws: Laws,
    /// Any of: friction at rest above the kinetic one, rotational friction other than along
    /// it, viscous drag of the mud along the hole and about the axis, a clearance that changes
    /// along the hole.
    pub full: bool,
}

/// Which code does the step: the processor's best instructions, and the laws of contact.
#[derive(Clone)]
pub struct Stepper<R: Real = f64> {
    step: unsafe fn(RegionRows<'_, R>, &StepInput, Laws, &mut Scratch<R>) -> StepLosses,
    scratch: Box<Scratch<R>>,
    laws: Laws,
    damp: unsafe fn(RegionRows<'_, R>, &MassDamping) -> f64,
    peak: unsafe fn(usize) -> u64,
    /// Name of the instruction set in use.
    pub instructions: &'static str,
    /// Whether it adds to a product before it is rounded.
    pub is_fused: bool,
}

impl<R: Real> std::fmt::Debug for Stepper<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stepper").field("instructions", &self.instructions).finish()
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident $(, $features:literal)?) => {
        mod $set {
            use super::*;
            use crate::simd::dispatch::$number;

            $(#[target_feature(enable = $features)])?
            pub(super) fn step<R: Registers, const FULL: bool>(
                rows: RegionRows<'_, R>,
                input: &StepInput,
                laws: Laws,
                scratch: &mut Scratch<R>,
            ) -> StepLosses {
                sweep::<$number<R>, FULL>(rows, input, laws, scratch)
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn damp<R: Registers>(
                region: RegionRows<'_, R>,
                mass_damping: &MassDamping,
            ) -> f64 {
                super::damping::damp::<$number<R>>(region, mass_damping)
            }

            pub(super) fn is_fused<R: Registers>() -> bool {
                <$number<R>>::FUSED
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn peak<R: Registers>(rounds: usize) -> u64 {
                super::peak::work::<$number<R>>(rounds)
            }
        }
    };
}
for_each_instruction_set!(compiled_for);

fn counting<R: Real, const FULL: bool>(
    rows: RegionRows<'_, R>,
    input: &StepInput,
    laws: Laws,
) -> StepLosses {
    sweep::<Counted<R>, FULL>(rows, input, laws, &mut Scratch::new())
}

impl<R: Registers> Stepper<R> {
    /// The fastest code for this processor with the requested features.
    pub fn new(abilities: Abilities) -> Self {
        Self::all(abilities).swap_remove(0)
    }

    /// Every code that this processor can run, the fastest first; the baseline always is the last.
    pub fn all(abilities: Abilities) -> Vec<Self> {
        macro_rules! choose {
            ($set:ident, $name:literal) => {
                Self {
                    step: if abilities.full {
                        $set::step::<R, true>
                    } else {
                        $set::step::<R, false>
                    },
                    scratch: Box::new(Scratch::new()),
                    laws: abilities.laws,
                    damp: $set::damp::<R>,
                    peak: $set::peak::<R>,
                    instructions: $name,
                    is_fused: $set::is_fused::<R>(),
                }
            };
        }
        available_instruction_sets!(choose)
    }
}

impl<R: Real> Stepper<R> {
    /// Advances the chain by one step of such code, its lower region by all of its own within it,
    /// and counts the operations.
    pub fn count(abilities: Abilities, chain: &mut Chain<R>, input: &StepInput) -> Flops {
        let step = if abilities.full { counting::<R, true> } else { counting::<R, false> };
        counted::count(|| {
            coupled_step(chain, input, |chain, region, input| {
                step(chain.region(region), input, abilities.laws)
            });
        })
    }

    /// Does as much arithmetic in the step's registers as the processor can, `rounds` times; how
    /// many floating-point operations that was.
    pub fn work(&self, rounds: usize) -> u64 {
        // SAFETY: as for a step.
        unsafe { (self.peak)(rounds) }
    }

    /// Applies mass-proportional damping and returns the energy that it removes, J. Its step is
    /// that of the uppermost region.
    pub fn damp(&self, chain: &mut Chain<R>, mass_damping: &MassDamping) -> f64 {
        let mut taken = 0.0;
        for region in 0..chain.regions() {
            let dt = mass_damping.dt / chain.parts_at(chain.rows_of(region).start);
            let own = MassDamping { dt, ..*mass_damping };
            // SAFETY: as for a step.
            taken += unsafe { (self.damp)(chain.region(region), &own) };
        }
        taken
    }

    /// Advances the chain by one step, its lower region by all of its own within it.
    pub fn step(&mut self, chain: &mut Chain<R>, input: &StepInput) -> StepLosses {
        coupled_step(chain, input, |chain, region, input| {
            self.step_region(chain.region(region), input)
        })
    }

    /// Advances a region of a chain by one step.
    pub fn step_region(&mut self, rows: RegionRows<'_, R>, input: &StepInput) -> StepLosses {
        // SAFETY: `all` lists only code whose instructions the processor was found to have.
        unsafe { (self.step)(rows, input, self.laws, &mut self.scratch) }
    }
}

/// A step of the whole chain by `step`, which takes one of a region: of the upper one, and then all
/// those of the lower one within it.
pub fn coupled_step<R: Real>(
    chain: &mut Chain<R>,
    input: &StepInput,
    mut step: impl FnMut(&mut Chain<R>, usize, &StepInput) -> StepLosses,
) -> StepLosses {
    let Some(coupled) = Coupled::begin(chain, input.dt, input.stiffness_damping) else {
        return step(chain, 0, input);
    };
    let mut losses = step(chain, 0, input);
    losses.damping -= coupled.damping_W * input.dt;
    let parts = chain.parts();
    let own = StepInput { dt: input.dt / f64::from(parts), ..*input };
    for part in 0..parts {
        losses += step(chain, 1, &own);
        if part == 0 {
            coupled.lead(chain, own.dt);
        }
    }
    losses
}

/// Offset of a node from the hole's axis as used for its wall, and the clearance there, m: without
/// a time step.
#[cfg(test)]
pub fn met(chain: &Chain, index: usize) -> (crate::simd::vector::Vector<f64>, f64) {
    use crate::simd::vector::Vector;

    let (row, lane) = chain.place(index);
    let input =
        StepInput { dt: 0.0, stiffness_damping: 0.0, dissipation: 0.0, stribeck_speed: 1.0 };
    let mut prediction = nodes::Prediction::none();
    let (n, state) = (&chain.node_blocks[row], &chain.states[row]);
    gap::<f64, true>(&mut prediction, n, state, &input, lane);
    let [x, y, z] = &prediction.offset;
    (Vector(x.0[lane], y.0[lane], z.0[lane]), prediction.clearance.0[lane])
}

#[inline(always)]
fn sweep<N: Number, const FULL: bool>(
    mut region: RegionRows<'_, N::Real>,
    input: &StepInput,
    laws: Laws,
    scratch: &mut Scratch<N::Real>,
) -> StepLosses {
    region.close();
    let RegionRows { states, node_blocks, element_blocks, imbalance_blocks } = region;
    let rows = node_blocks.len();
    let mut losses = Losses::none();
    let Scratch { strains, prediction, before, pulls, last } = scratch;
    // The last row of elements pulls at the first row of nodes, too: it and the first come before
    // all nodes.
    let (e, below) = (&mut element_blocks[rows - 1], ends(states, rows - 1));
    pull::<N>(last, strains, e, below, input, &mut losses);
    if rows > 1 {
        let (e, below) = (&mut element_blocks[0], ends(states, 0));
        pull::<N>(&mut pulls[0], strains, e, below, input, &mut losses);
    }
    // The last row of a lane pulls at the first node of the next lane.
    pulls[2].follow_in_lanes(last);

    for (row, n) in node_blocks.iter_mut().enumerate() {
        let [a, b, c] = &mut *pulls;
        // Three rows of pulls go round: of the elements above, below, and below the next nodes.
        let (above, below, next) = match row % 3 {
            0 => (c, a, b),
            1 => (a, b, c),
            _ => (b, c, a),
        };
        // The next row of elements is between the nodes below these.
        let (state, under) = states[row..].split_first_mut().expect("a row of nodes");
        let mut elements = if row + 2 < rows {
            Some((&mut element_blocks[row + 1], ends(under, 0)))
        } else {
            None
        };
        // A single row is above and below itself.
        let below = if row + 1 == rows { &*last } else { &*below };
        let mut imbalances = imbalance_blocks.get_mut(row);
        if let Some(imbalances) = &imbalances {
            if N::Real::FINE {
                for lane in lanes::<Pair<N>>() {
                    throw::<Pair<N>>(above, before, imbalances, state, input, lane);
                }
            } else {
                for lane in lanes::<N>() {
                    throw::<N>(above, before, imbalances, state, input, lane);
                }
            }
        }
        for lane in lanes::<N>() {
            predict::<N, FULL>(prediction, n, state, above, below, input, lane);
        }
        let mut touches = false;
        for lane in lanes::<N>() {
            touches |= gap::<N, FULL>(prediction, n, state, input, lane);
        }
        if touches {
            if laws.hertz {
                for lane in lanes::<Pair<N>>() {
                    normal_contact::<Pair<N>, true>(prediction, n, input, lane);
                }
            } else {
                for lane in lanes::<Pair<N>>() {
                    normal_contact::<Pair<N>, false>(prediction, n, input, lane);
                }
            }
        }
        if let Some((e, ends)) = &mut elements {
            for lane in lanes::<Pair<N>>() {
                chord::<Pair<N>>(strains, e, ends, lane);
            }
            for lane in lanes::<N>() {
                twist::<N>(next, strains, e, ends, input, &mut losses, lane);
            }
        }
        if touches {
            if laws.vector {
                for lane in lanes::<Pair<N>>() {
                    friction::<Pair<N>, true, FULL>(prediction, n, input, lane);
                }
            } else {
                for lane in lanes::<Pair<N>>() {
                    friction::<Pair<N>, false, FULL>(prediction, n, input, lane);
                }
            }
        }
        if let Some((e, ends)) = &mut elements {
            for lane in lanes::<N>() {
                strain::<N>(strains, e, ends, input, &mut losses, lane);
            }
            for lane in lanes::<N>() {
                bend::<N>(next, strains, e, ends, lane);
            }
        }
        if touches {
            for lane in lanes::<N>() {
                correct::<N, FULL, true>(prediction, n, state, input, &mut losses, lane);
            }
        } else {
            for lane in lanes::<N>() {
                correct::<N, FULL, false>(prediction, n, state, input, &mut losses, lane);
            }
        }
        for lane in lanes::<N>() {
            rotate_directors::<N>(n, state, above, below, input, lane);
        }
        if let Some(imbalances) = &mut imbalances {
            // Two registers at a time hide the division of doubles. The additional data of single
            // precision leave no registers for two.
            if N::Real::FINE {
                for lane in lanes::<Pair<N>>() {
                    follow::<Pair<N>>(before, imbalances, n, state, input, lane);
                }
            } else {
                for lane in lanes::<N>() {
                    follow::<N>(before, imbalances, n, state, input, lane);
                }
            }
        }
    }
    let sum = |row: Row<N::Real>| row.0.as_ref().iter().map(|x| x.to_f64()).sum::<f64>();
    StepLosses {
        // Sums are over v + v', twice the mean velocity.
        contact: sum(losses.contact) * 0.5 * input.dt,
        mud: sum(losses.mud) * 0.5,
        damping: sum(losses.damping) * input.dt,
    }
}

/// A row of elements, from their chords to the forces and moments on their ends.
#[inline(always)]
fn pull<N: Number>(
    into: &mut Pull<N::Real>,
    strains: &mut Strains<N::Real>,
    e: &mut ElementBlock<N::Real>,
    ends: &[StateBlock<N::Real>; 2],
    input: &StepInput,
    losses: &mut Losses<N::Real>,
) {
    for lane in lanes::<Pair<N>>() {
        chord::<Pair<N>>(strains, e, ends, lane);
    }
    for lane in lanes::<N>() {
        twist::<N>(into, strains, e, ends, input, losses, lane);
    }
    for lane in lanes::<N>() {
        strain::<N>(strains, e, ends, input, losses, lane);
    }
    for lane in lanes::<N>() {
        bend::<N>(into, strains, e, ends, lane);
    }
}

/// The states of the two ends of a row of elements.
#[inline(always)]
fn ends<R: Real>(states: &[StateBlock<R>], row: usize) -> &[StateBlock<R>; 2] {
    states[row..].first_chunk().expect("the states close with a row more")
}
