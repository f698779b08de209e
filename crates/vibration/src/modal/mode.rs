//! A natural mode.

use nalgebra::Complex;

use super::{chain::Chain, factors::MOTIONS, family::Family};
use crate::complex;

/// Which way a mode goes round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Whirl {
    /// With the rotation.
    Forward,
    /// Against it.
    Backward,
    /// To and fro: neither.
    Planar,
}

/// Part of a circle's precession from which a mode goes round.
const ROUND: f64 = 0.1;

impl Whirl {
    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Backward => "backward",
            Self::Planar => "planar",
        }
    }

    pub(super) fn of(precession: f64) -> Self {
        if precession > ROUND {
            Self::Forward
        } else if precession < -ROUND {
            Self::Backward
        } else {
            Self::Planar
        }
    }
}

/// A natural mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Natural frequency, Hz.
    pub frequency_Hz: f64,
    /// Family with most of its kinetic energy.
    pub family: Family,
    /// Parts of its kinetic energy: lateral, axial, torsional.
    pub energy: [f64; 3],
    /// Part of its kinetic energy below the top of the assembly.
    pub in_assembly: f64,
    /// Precession: 1 for a circle with the rotation, −1 against it, 0 for a plane vibration.
    pub precession: f64,
    /// Place of the greatest strain of the string's steel: by bending in a lateral mode, tension in
    /// an axial one, twist in a torsional one.
    pub most_strained: Place,
    /// Its shape at each node of the string from the top down: displacement towards the high side,
    /// to the right of it and along the hole, m, rotation about the same directions, rad; the
    /// largest displacement is 1 m, of a torsional mode the largest turn 1 rad. The high side is
    /// that at the bit, carried up the hole without twisting.
    pub shape: Vec<[Complex<f64>; MOTIONS]>,
}

impl Mode {
    /// Which way it goes round; of lateral modes.
    pub fn whirl(&self) -> Option<Whirl> {
        (self.family == Family::Lateral).then(|| Whirl::of(self.precession))
    }

    /// Farthest that a node goes across the hole, m.
    pub fn across_m(&self, node: usize) -> f64 {
        let [x, y, ..] = self.shape[node];
        farthest(x, y)
    }
}

/// Long half axis of the ellipse of two motions of one frequency.
pub(super) fn farthest(x: Complex<f64>, y: Complex<f64>) -> f64 {
    // |x|² + |y|² ± |x² + y²| are twice the squares of the half axes.
    (0.5 * (x.norm_sqr() + y.norm_sqr() + complex::norm(x * x + y * y))).sqrt()
}

/// Kinetic energy of a motion by family, as fractions, and its fraction at and below a node.
pub(super) fn energy(chain: &Chain, motion: &[Complex<f64>], assembly: usize) -> ([f64; 3], f64) {
    let mut parts = [0.0; 3];
    let mut below = 0.0;
    for node in 0..chain.nodes() {
        for (part, family) in parts.iter_mut().zip(Family::ALL) {
            for &k in family.motions() {
                let own = chain.mass[node][k] * motion[node * MOTIONS + k].norm_sqr();
                *part += own;
                if node >= assembly {
                    below += own;
                }
            }
        }
    }
    let sum: f64 = parts.iter().sum();
    (parts.map(|part| part / sum), below / sum)
}

/// Precession of a motion.
pub(super) fn precession(chain: &Chain, motion: &[Complex<f64>]) -> f64 {
    let (mut round, mut all) = (0.0, 0.0);
    for node in 0..chain.nodes() {
        let [x, y] = [motion[node * MOTIONS], motion[node * MOTIONS + 1]];
        let mass = chain.mass[node][0];
        round += mass * 2.0 * (x * y.conj()).im;
        all += mass * (x.norm_sqr() + y.norm_sqr());
    }
    if all > 0.0 { round / all } else { 0.0 }
}

// A place in the string.

/// A place in the string.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Measured depth, m.
    pub md_m: f64,
    /// Distance from the bit, m.
    pub from_bit_m: f64,
    /// The component there.
    pub component: String,
}
