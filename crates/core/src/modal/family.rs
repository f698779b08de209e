//! Lateral, axial and torsional motion.

use super::{
    chain::Chain,
    factors::MOTIONS,
    krylov::{Krylov, Ritz},
    line::Line,
    search::RealMode,
};

/// What a mode is mostly: where most of its kinetic energy is.
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

/// Steps of Lanczos's method from a guess, at most, and between two looks.
const MOST: usize = 60;
const STEPS: usize = 6;

/// What may be left over of a mode.
const CONVERGED: f64 = 1e-6;

/// Part of its energy that a mode may share with one found before, to be another.
const ANOTHER: f64 = 0.5;

/// The first modes of the axial or of the torsional family, by rising frequency.
///
/// Those of the chain that moves in this way alone are the guesses. From each of them Lanczos's
/// method in the whole chain goes to the mode that has most of it: a shape that bends takes the
/// lateral motion along, and lateral modes of about the same frequency, of which there may be
/// many between two of the family, are passed by. None where a guess came to no mode.
pub(super) fn modes(chain: &Chain, family: Family, count: usize) -> Option<Vec<RealMode>> {
    let motion = family.motions()[0];
    let line = Line::of(chain, motion);
    let mut found: Vec<RealMode> = Vec::new();
    for number in 0..count.min(line.freedoms()) {
        let guess = line.mode(number);
        let mut whole = vec![0.0; chain.nodes() * MOTIONS];
        for (node, moved) in guess.shape.iter().enumerate() {
            whole[node * MOTIONS + motion] = *moved;
        }
        found.push(follow(chain, guess.lambda, whole, &found)?);
    }
    found.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    Some(found)
}

/// The mode that has most of a guess.
fn follow(chain: &Chain, lambda: f64, guess: Vec<f64>, before: &[RealMode]) -> Option<RealMode> {
    let mut space = Krylov::new(chain, lambda, &[guess]);
    loop {
        let mut fresh = true;
        for _ in 0..STEPS {
            fresh = space.extend();
        }
        let mut found = space.ritz();
        // The first vector of the basis is the guess.
        let shares = |of: &Ritz| of.parts[0].powi(2);
        found.sort_by(|a, b| shares(b).total_cmp(&shares(a)));
        let mut sure = found.iter().take_while(|of| of.residual < CONVERGED || !fresh);
        let other = sure.find_map(|of| {
            let mode = RealMode { lambda: of.lambda, motion: space.motion(of) };
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
        if space.size() >= MOST || !fresh {
            return None;
        }
    }
}
