//! The lowest part of the string: collars, stabilisers and heavy-weight pipe.

use nalgebra::Complex;
use wholestring::{sizing::assembly_top_m, string::DrillString};

use super::{
    ModalError,
    chain::Chain,
    family::{Family, LOWEST_HZ},
    mode::Mode,
    motions::{SmallMotions, motion},
    search,
    whirl::Turning,
};

/// String above the assembly that moves with it, m: above that it is held.
const ABOVE_M: f64 = 60.0;

/// An assembly that would be shorter is none, m.
const SHORT_M: f64 = 15.0;

/// The assembly where drill pipe begins as low as a bit, or nothing ends it, m.
const LONGEST_M: f64 = 300.0;

/// Modes that are looked for beyond those wanted, and how many rounds.
const BEYOND: usize = 6;
const ROUNDS: usize = 6;

/// Length of a string's assembly, m: from the bit up to where ordinary drill pipe begins, as the
/// mesh and static BHA analysis have it; 300 m where there is hardly any other.
pub fn assembly_length_m(string: &DrillString) -> f64 {
    let length_m = assembly_top_m(string);
    if length_m > SHORT_M { length_m } else { LONGEST_M.min(string.length_m()) }
}

/// The lowest part of a string, and its lateral modes.
///
/// It is cut out of the string 60 m above its top, where it is held; this does not affect lateral
/// modes that have most of their energy in it. Modes that move mostly above it are left out.
#[derive(Debug, Clone)]
pub struct Assembly<'a> {
    pub(super) motions: &'a SmallMotions,
    pub(super) chain: Chain,
    /// First node of the chain, and of the assembly.
    pub(super) first: usize,
    top: usize,
}

impl SmallMotions {
    /// The assembly: the string from the bit up to a length, m.
    pub fn assembly(&self, length_m: f64) -> Assembly<'_> {
        Assembly::new(self, length_m)
    }
}

/// Modes of the assembly that does not rotate, and how rotation couples them.
pub(super) struct Modes {
    pub(super) rest: Vec<search::RealMode>,
    pub(super) turning: Turning,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(motions: &'a SmallMotions, length_m: f64) -> Self {
        let mesh = &motions.rest.mesh;
        let nearest = |from_bit_m: f64| {
            if from_bit_m >= mesh.length_m() { 0 } else { mesh.nearest_node(from_bit_m) }
        };
        let (first, top) = (nearest(length_m + ABOVE_M), nearest(length_m));
        let chain = if first == 0 { motions.chain.clone() } else { motions.chain.below(first) };
        Self { motions, chain, first, top }
    }

    /// First node of the assembly, from the top of the string down.
    pub fn top_node(&self) -> usize {
        self.top
    }

    /// Length of the assembly, m.
    pub fn length_m(&self) -> f64 {
        self.motions.rest.mesh.nodes[self.top].from_bit_m
    }

    /// The first lateral modes of the assembly from a frequency on, Hz, at a rotary speed. A motion
    /// of less than 0.001 Hz, such as that of a bow around a vertical hole, is none of them.
    ///
    /// # Errors
    /// Where they were not all found.
    pub fn lateral(
        &self,
        from_Hz: f64,
        count: usize,
        rotary_rad_per_s: f64,
    ) -> Result<Vec<Mode>, ModalError> {
        let modes = self.modes(from_Hz, count)?;
        let found = modes.turning.at(rotary_rad_per_s);
        let found = found.iter().map(|mode| self.mode(&modes, mode.omega, &mode.parts));
        Ok(found.filter(is_own).take(count).collect())
    }

    /// Modes enough for so many lateral ones of its own, from a frequency on.
    pub(super) fn modes(&self, from_Hz: f64, count: usize) -> Result<Modes, ModalError> {
        let incomplete = ModalError::Incomplete { count, from_Hz };
        let omega = std::f64::consts::TAU * from_Hz.max(LOWEST_HZ);
        let mut search_count = count + BEYOND;
        for _ in 0..ROUNDS {
            let rest = search::above(&self.chain, omega, search_count).ok_or(incomplete.clone())?;
            let turning = Turning::new(&self.chain, &rest);
            let all = rest.len() < search_count;
            let modes = Modes { rest, turning };
            let own = |number: usize| {
                let mut parts = vec![Complex::new(0.0, 0.0); modes.rest.len()];
                parts[number] = Complex::new(1.0, 0.0);
                is_own(&self.mode(&modes, modes.rest[number].lambda.max(0.0).sqrt(), &parts))
            };
            if all || (0..modes.rest.len()).filter(|number| own(*number)).count() >= count + 2 {
                return Ok(modes);
            }
            search_count *= 2;
        }
        Err(incomplete)
    }

    pub(super) fn mode(&self, modes: &Modes, omega: f64, parts: &[Complex<f64>]) -> Mode {
        self.motions.mode(&self.chain, omega, &motion(&modes.rest, parts), self.top)
    }
}

/// Whether a mode is lateral and has most of its energy in the assembly.
pub(super) fn is_own(mode: &Mode) -> bool {
    mode.family == Family::Lateral && mode.in_assembly >= 0.5
}
