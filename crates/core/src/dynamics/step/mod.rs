//! One step of the whole chain: the inner loop of everything.
//!
//! Leapfrog (central differences): forces at the present positions kick the velocities across the
//! step, the velocities carry the positions on. Contact and friction act within the step, implicitly
//! at each node, so that they never limit it. One pass does both: a row of elements is evaluated from
//! positions that no node has left yet, then the nodes above them are moved, while all of it is
//! still in the first-level cache.
//!
//! A row is worked on in short loops, one after the other. What one register of lanes waits for (a root or a division
//! takes twenty cycles) is then hidden behind the others; in one long loop the processor does not see far enough
//! ahead.
//!
//! Directors move on the sphere by Cayley's rotation, which keeps their length and the right angle
//! to their angular velocity to rounding.

mod elements;
mod lane;
mod nodes;
mod touch;

use super::chain::{Chain, Row, StateBlock};
use crate::rod::number::{Number, Real};
#[cfg(not(target_arch = "x86_64"))]
use crate::rod::wide::Pair;
use elements::{Chords, Pull, bend, twist};
use lane::lanes;
use nodes::{Flight, fly, land, rub, slow, turn};
use touch::push;

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
pub struct Stepper<R: Real = f64> {
    step: unsafe fn(&mut Chain<R>, &StepInput) -> StepLosses,
    /// Name of the instruction set in use.
    pub instructions: &'static str,
}

impl<R: Real> std::fmt::Debug for Stepper<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stepper")
            .field("instructions", &self.instructions)
            .finish()
    }
}

macro_rules! compiled_for {
    ($name:ident, $number:ty $(, $features:literal)?) => {
        $(#[target_feature(enable = $features)])?
        fn $name<R: Real, const HERTZ: bool, const VECTOR: bool, const FULL: bool>(
            chain: &mut Chain<R>,
            input: &StepInput,
        ) -> StepLosses {
            sweep::<$number, HERTZ, VECTOR, FULL>(chain, input)
        }
    };
}

#[cfg(target_arch = "x86_64")]
compiled_for!(avx512, R::Zmm, "avx512f,avx512dq,avx512vl,avx2,fma");
#[cfg(target_arch = "x86_64")]
compiled_for!(avx2, R::Ymm, "avx2,fma");
#[cfg(target_arch = "x86_64")]
compiled_for!(baseline, R::Xmm);
#[cfg(target_arch = "aarch64")]
compiled_for!(baseline, Pair<R::Fused>);
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
compiled_for!(baseline, Pair<R>);

impl<R: Real> Stepper<R> {
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
                        (true, true, false) => $function::<R, true, true, false>,
                        (true, false, false) => $function::<R, true, false, false>,
                        (false, true, false) => $function::<R, false, true, false>,
                        (false, false, false) => $function::<R, false, false, false>,
                        (true, true, true) => $function::<R, true, true, true>,
                        (true, false, true) => $function::<R, true, false, true>,
                        (false, true, true) => $function::<R, false, true, true>,
                        (false, false, true) => $function::<R, false, false, true>,
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
    pub fn step(&self, chain: &mut Chain<R>, input: &StepInput) -> StepLosses {
        // SAFETY: `all` lists only code whose instructions the processor was found to have.
        unsafe { (self.step)(chain, input) }
    }
}

/// Energy lost by each lane: friction's in J, the contact's over half the step, twice the mud's in J, the damping's
/// power in W.
struct Losses<R: Real> {
    friction: Row<R>,
    contact: Row<R>,
    mud: Row<R>,
    damping: Row<R>,
}

impl<R: Real> Losses<R> {
    fn none() -> Self {
        let zero = Row::filled(0.0);
        Self {
            friction: zero,
            contact: zero,
            mud: zero,
            damping: zero,
        }
    }
}

#[inline(always)]
fn sweep<N: Number, const HERTZ: bool, const VECTOR: bool, const FULL: bool>(
    chain: &mut Chain<N::Real>,
    input: &StepInput,
) -> StepLosses {
    chain.close();
    let Chain {
        states,
        node_blocks,
        element_blocks,
        ..
    } = chain;
    let rows = node_blocks.len();
    let mut losses = Losses::none();
    let mut pulls = [Pull::none(); 2];
    let (mut chords, mut flight) = (Chords::none(), Flight::none());

    // The last row of elements pulls at the first row of nodes. It is evaluated again when its turn comes.
    let (mut last, state) = (element_blocks[rows - 1], ends(states, rows - 1));
    let (above, mut twice) = (&mut pulls[1], Losses::none());
    for lane in lanes::<N>() {
        twist::<N>(
            above,
            &mut chords,
            &mut last,
            state,
            input,
            &mut twice,
            lane,
        );
    }
    for lane in lanes::<N>() {
        bend::<N>(above, &chords, &mut last, state, input, &mut twice, lane);
    }
    above.go_on();

    for (row, (e, n)) in element_blocks.iter_mut().zip(node_blocks).enumerate() {
        let state = ends(states, row);
        let [even, odd] = &mut pulls;
        let (below, above) = if row % 2 == 0 {
            (even, odd)
        } else {
            (odd, even)
        };
        for lane in lanes::<N>() {
            twist::<N>(below, &mut chords, e, state, input, &mut losses, lane);
        }
        for lane in lanes::<N>() {
            slow::<N>(&mut flight, n, &state[0], input, lane);
        }
        for lane in lanes::<N>() {
            bend::<N>(below, &chords, e, state, input, &mut losses, lane);
        }
        let state = &mut state[0];
        fly::<N, FULL>(&mut flight, n, state, above, below, input);
        for lane in lanes::<N>() {
            push::<N, HERTZ>(&mut flight, n, input, lane);
        }
        rub::<N, VECTOR, FULL>(&mut flight, n, input);
        land::<N>(&flight, n, state, input, &mut losses);
        for lane in lanes::<N>() {
            turn::<N>(n, state, above, below, input, lane);
        }
    }
    let sum = |row: Row<N::Real>| row.0.as_ref().iter().map(|x| x.to_f64()).sum::<f64>();
    StepLosses {
        friction: sum(losses.friction),
        contact: sum(losses.contact) * 0.5 * input.dt,
        mud: sum(losses.mud) * 0.5,
        damping: sum(losses.damping) * input.dt,
    }
}

/// The states of the two ends of a row of elements.
#[inline(always)]
fn ends<R: Real>(states: &mut [StateBlock<R>], row: usize) -> &mut [StateBlock<R>; 2] {
    states[row..]
        .first_chunk_mut()
        .expect("the states close with a row more")
}
