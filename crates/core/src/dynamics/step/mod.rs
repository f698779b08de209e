//! One step of the whole chain: the inner loop of everything.
//!
//! Leapfrog (central differences): forces at the present positions kick the velocities across the
//! step, the velocities carry the positions on. Contact and friction act within the step, implicitly
//! at each node, so that they never limit it. One pass does both: a tile of elements is evaluated from
//! positions that no node has left yet, then the nodes above them are moved, while all of it is
//! still in the first-level cache.
//!
//! Directors move on the sphere by Cayley's rotation, which keeps their length and the right angle
//! to their angular velocity to rounding.

// A loop over lanes is what the compiler widens; iterators over a dozen arrays would hide it.
#![allow(clippy::needless_range_loop)]

mod elements;
mod lane;
mod nodes;
mod touch;

use super::chain::Chain;
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use crate::rod::number::Fused;
use crate::rod::{lanes::LANES, number::Number};
use elements::Pull;
use lane::Eight;
use nodes::{Flight, turn};
use touch::Touch;

/// What is the same for all nodes in a step.
#[derive(Debug, Clone, Copy)]
pub struct StepInput {
    /// Step, s.
    pub dt: f64,
    /// Stiffness-proportional damping, s.
    pub stiffness_damping: f64,
    /// Mass-proportional damping, 1/s.
    pub mass_damping: f64,
    /// Axial velocity of the rigid motion that mass-proportional damping leaves alone, m/s.
    pub rigid_velocity: f64,
    /// Spin of that motion, rad/s.
    pub rigid_spin: f64,
    /// Hunt-Crossley dissipation of the Hertz law, s/m.
    pub dissipation: f64,
    /// Sliding speed at which the friction at rest has half decayed to the kinetic one, m/s.
    pub stribeck_speed: f64,
}

/// Energies that left the string in a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct StepLosses {
    /// To friction on the wall.
    pub friction: f64,
    /// To the wall's contact forces.
    pub contact: f64,
    /// To the mud and to mass-proportional damping.
    pub mud: f64,
    /// To stiffness-proportional damping.
    pub damping: f64,
}

/// What the stepper must be able to do; less is faster.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Abilities {
    /// Hertz contact, not the linear one.
    pub hertz: bool,
    /// Vector friction, not the independent one.
    pub vector: bool,
    /// Any of: friction at rest above the kinetic one, friction around the hole other than along it,
    /// viscous drag of the mud along the hole and about the axis, a clearance that changes along the hole.
    pub full: bool,
}

/// Which code does the step: the processor's best instructions, and the two laws.
#[derive(Clone, Copy)]
pub struct Stepper {
    step: unsafe fn(&mut Chain, &StepInput) -> StepLosses,
    /// Name of the instruction set in use.
    pub instructions: &'static str,
}

impl std::fmt::Debug for Stepper {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stepper")
            .field("instructions", &self.instructions)
            .finish()
    }
}

macro_rules! compiled_for {
    ($name:ident, $number:ty $(, $features:literal)?) => {
        $(#[target_feature(enable = $features)])?
        fn $name<const HERTZ: bool, const VECTOR: bool, const FULL: bool>(
            chain: &mut Chain,
            input: &StepInput,
        ) -> StepLosses {
            sweep::<$number, HERTZ, VECTOR, FULL>(chain, input)
        }
    };
}

#[cfg(target_arch = "x86_64")]
compiled_for!(avx512, Fused, "avx512f,avx512dq,avx512vl,avx2,fma");
#[cfg(target_arch = "x86_64")]
compiled_for!(avx2, Fused, "avx2,fma");
#[cfg(target_arch = "aarch64")]
compiled_for!(baseline, Fused);
#[cfg(not(target_arch = "aarch64"))]
compiled_for!(baseline, f64);

impl Stepper {
    /// The fastest code for this processor that does what is asked for.
    pub fn new(abilities: Abilities) -> Self {
        Self::all(abilities)[0]
    }

    /// Every code that this processor can run, the fastest first; the baseline always is the last.
    pub fn all(abilities: Abilities) -> Vec<Self> {
        let Abilities {
            hertz,
            vector,
            full,
        } = abilities;
        macro_rules! choose {
            ($function:ident, $name:literal) => {
                Self {
                    step: match (hertz, vector, full) {
                        (true, true, false) => $function::<true, true, false>,
                        (true, false, false) => $function::<true, false, false>,
                        (false, true, false) => $function::<false, true, false>,
                        (false, false, false) => $function::<false, false, false>,
                        (true, true, true) => $function::<true, true, true>,
                        (true, false, true) => $function::<true, false, true>,
                        (false, true, true) => $function::<false, true, true>,
                        (false, false, true) => $function::<false, false, true>,
                    },
                    instructions: $name,
                }
            };
        }
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            let fma = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            if fma
                && is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl")
            {
                all.push(choose!(avx512, "AVX-512"));
            }
            if fma {
                all.push(choose!(avx2, "AVX2"));
            }
        }
        all.push(choose!(baseline, "baseline"));
        all
    }

    /// Advances the chain by one step.
    pub fn step(&self, chain: &mut Chain, input: &StepInput) -> StepLosses {
        // SAFETY: `all` lists only code whose instructions the processor was found to have.
        unsafe { (self.step)(chain, input) }
    }
}

/// Blocks of eight elements in a tile.
const TILE: usize = 4;

/// Energy lost by each lane.
#[derive(Default)]
struct Losses {
    friction: [f64; LANES],
    contact: [f64; LANES],
    mud: [f64; LANES],
    damping: [f64; LANES],
}

#[inline(always)]
fn sweep<N: Number, const HERTZ: bool, const VECTOR: bool, const FULL: bool>(
    chain: &mut Chain,
    input: &StepInput,
) -> StepLosses {
    let blocks = chain.node_blocks.len();
    let mut losses = Losses::default();
    let mut pull = Pull::NONE;
    let mut flights = [Flight::NONE; TILE];
    let mut touch = Touch::NONE;
    for first in (0..blocks).step_by(TILE) {
        let tile = TILE.min(blocks - first);
        let which = |place: usize| Eight {
            block: first + place,
            place,
        };
        let elements = &mut chain.element_blocks[first..first + tile];
        for (place, elements) in elements.iter_mut().enumerate() {
            pull.add_block::<N>(elements, &chain.state, which(place), input, &mut losses);
        }
        let nodes = &mut chain.node_blocks[first..first + tile];
        for (place, (nodes, flight)) in nodes.iter().zip(&mut flights).enumerate() {
            let where_to = flight.fly::<N, FULL>(nodes, &chain.state, which(place), input, &pull);
            touch.expect(nodes, place, &where_to);
        }
        touch.push::<N, HERTZ>(input);
        for (place, (nodes, flight)) in nodes.iter_mut().zip(&flights).enumerate() {
            let push = touch.pushes(place);
            let state = &mut chain.state;
            flight.land::<N, VECTOR, FULL>(nodes, state, first + place, push, input, &mut losses);
        }
        for (place, nodes) in nodes.iter().enumerate() {
            turn::<N>(nodes, &mut chain.state, which(place), input, &pull);
        }
        pull.carry(tile * LANES);
    }
    StepLosses {
        friction: losses.friction.iter().sum(),
        contact: losses.contact.iter().sum(),
        mud: losses.mud.iter().sum(),
        damping: losses.damping.iter().sum::<f64>() * input.dt,
    }
}
