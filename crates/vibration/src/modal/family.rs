//! Lateral, axial and torsional motion.

use super::{
    chain::Chain,
    factors::MOTIONS,
    krylov::{Krylov, Ritz},
    line::Line,
    search::RealMode,
};

/// Family of a mode: the kind of motion with most of its kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Across the string.
    Lateral,
    /// Along it.
    Axial,
    /// About its axis.
    Torsional,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Lateral, Self::Axial, Self::Torsional];

    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lateral => "lateral",
            Self::Axial => "axial",
            Self::Torsional => "torsional",
        }
    }

    /// Which of a node's motions are this.
    pub(super) const fn motions(self) -> &'static [usize] {
        match self {
            Self::Lateral => &[0, 1, 3, 4],
            Self::Axial => &[2],
            Self::Torsional => &[5],
        }
    }
}

/// Lowest natural frequency, Hz: motions that are slower, or of an unstable state, do not vibrate
/// as far as rounding lets one tell.
pub(super) const LOWEST_HZ: f64 = 1e-3;

/// Square of its angular frequency, rad²/s².
pub(super) fn least_lambda() -> f64 {
    (std::f64::consts::TAU * LOWEST_HZ).powi(2)
}

/// Vectors that Lanczos's method makes from a guess, at most: a stretch of pipe on its low side has
/// hundreds of lateral modes of about one frequency, among which a torsional one is shared out.
const MAX_VECTORS: usize = 480;

/// Vectors before the first look; later looks are apart by this part of the vectors so far.
const FIRST_LOOK: usize = 6;
const LOOKS_APART: f64 = 0.2;

/// Largest residual of a mode.
const CONVERGED: f64 = 1e-6;

/// Part of its energy that a mode may share with one found before, to be another.
const ANOTHER: f64 = 0.5;

/// Modes of a family.
pub(super) struct FamilyModes {
    /// Those that vibrate, by rising frequency.
    pub(super) vibrating: Vec<RealMode>,
    /// Number of further ones that do not vibrate: their frequency is below the lowest one, or the
    /// state is unstable.
    pub(super) others: usize,
}

/// The first modes of the axial or of the torsional family that vibrate; fewer than `count` where
/// the guess of the next one led to no mode.
///
/// Those of a chain that moves in this way alone, of the stiffness of `guesses`, are the guesses.
/// From each of them Lanczos's method in the whole chain goes to the mode that has most of it: a
/// shape that bends takes the lateral motion along, and lateral modes of about the same frequency,
/// of which there may be many between two of the family, are passed by.
pub(super) fn modes(chain: &Chain, guesses: &Chain, family: Family, count: usize) -> FamilyModes {
    let motion = family.motions()[0];
    let line = Line::of(guesses, motion);
    let mut found: Vec<RealMode> = Vec::new();
    let mut others = 0;
    for number in 0..line.freedoms() {
        if found.len() == count + others {
            break;
        }
        let guess = line.mode(number);
        let mut whole = vec![0.0; chain.nodes() * MOTIONS];
        for (node, moved) in guess.shape.iter().enumerate() {
            whole[node * MOTIONS + motion] = *moved;
        }
        let Some(mode) = follow(chain, guess.lambda, whole, &found) else { break };
        others += usize::from(mode.lambda < least_lambda());
        found.push(mode);
    }
    found.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    FamilyModes { vibrating: found.split_off(others), others }
}

/// Modes that a family has at most.
pub(super) fn count(chain: &Chain, family: Family) -> usize {
    Line::of(chain, family.motions()[0]).freedoms()
}

/// The mode that has most of a guess.
fn follow(chain: &Chain, lambda: f64, guess: Vec<f64>, before: &[RealMode]) -> Option<RealMode> {
    let mut space = Krylov::new(chain, lambda, &[guess]);
    let mut look = FIRST_LOOK;
    loop {
        let mut fresh = true;
        while fresh && space.size() < look {
            fresh = space.extend();
        }
        look = (look as f64 * (1.0 + LOOKS_APART)) as usize + FIRST_LOOK;
        let mut found = space.ritz();
        // The first vector of the basis is the guess.
        let shares = |ritz: &Ritz| ritz.parts[0].powi(2);
        found.sort_by(|a, b| shares(b).total_cmp(&shares(a)));
        let mut sure = found.iter().take_while(|ritz| ritz.residual < CONVERGED || !fresh);
        let other = sure.find_map(|sure| {
            let mode = RealMode { lambda: sure.lambda, motion: space.motion(sure) };
            let shared = |known: &RealMode| {
                let masses = chain.mass.iter().flatten();
                let both = mode.motion.iter().zip(&known.motion).zip(masses);
                both.map(|((x, y), m)| x * y * m).sum::<f64>()
            };
            before.iter().all(|known| shared(known).abs() < ANOTHER).then_some(mode)
        });
        if other.is_some() {
            return other;
        }
        if space.size() >= MAX_VECTORS || !fresh {
            return None;
        }
    }
}
