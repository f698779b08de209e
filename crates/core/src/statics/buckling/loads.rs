//! The shapes of a compressed pipe, the criterion of its buckling, and the critical loads of a
//! place.

use std::f64::consts::SQRT_2;

use serde::Serialize;

/// A shape that a compressed pipe may take, and whose load it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// The sinusoid: Dawson and Paslay, in a vertical hole Lubinski's first order.
    Sinusoidal,
    /// The helix as it begins: Chen, Lin and Cheatham.
    Helical,
    /// The finished helix: Wu and Juvkam-Wold.
    FullHelical,
}

impl Shape {
    /// `β` of `F² = β EI w_n/r`.
    pub fn beta(self) -> f64 {
        let root = match self {
            Self::Sinusoidal => 2.0,
            Self::Helical => 2.0 * SQRT_2,
            Self::FullHelical => 2.0 * (2.0 * SQRT_2 - 1.0),
        };
        root * root
    }

    /// Load over `(EI w²)^⅓` at the lower end of a long string in a vertical hole.
    pub(super) fn vertical(self) -> f64 {
        match self {
            Self::Sinusoidal => 1.94,
            Self::Helical | Self::FullHelical => 5.55,
        }
    }
}

// Whose loads a compression is compared with.

/// Whose loads a compression is compared with, for the sinusoid and for the helix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum Criterion {
    /// He and Kyllingstad: the sinusoid of Dawson and Paslay and the helix of Chen, Lin and
    /// Cheatham, pressed to the wall by the hole's curvature too.
    #[default]
    HeKyllingstad,
    /// Dawson and Paslay's sinusoid and Chen, Lin and Cheatham's helix, as in a straight hole.
    ChenLinCheatham,
    /// Dawson and Paslay's sinusoid and Wu and Juvkam-Wold's finished helix, as in a straight hole.
    WuJuvkamWold,
}

impl Criterion {
    /// The shapes whose loads it takes for the sinusoid and for the helix.
    pub const fn shapes(self) -> [Shape; 2] {
        let helix = match self {
            Self::HeKyllingstad | Self::ChenLinCheatham => Shape::Helical,
            Self::WuJuvkamWold => Shape::FullHelical,
        };
        [Shape::Sinusoidal, helix]
    }

    /// The shape that it takes for the helix.
    pub const fn helix(self) -> Shape {
        self.shapes()[1]
    }

    /// Whether the wall load from the hole's curvature is included.
    pub const fn counts_curvature(self) -> bool {
        matches!(self, Self::HeKyllingstad)
    }
}

// The critical loads of a place, of which each compression is compared with one.

/// The critical loads of one shape at one place: three at the most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CriticalLoads {
    /// From the least up, N; only so many of them.
    loads_N: [f64; 3],
    count: usize,
    /// The least load that counts, N.
    least_N: f64,
}

impl CriticalLoads {
    /// None yet but the least that counts, N.
    pub(super) fn none(least_N: f64) -> Self {
        Self { loads_N: [0.0; 3], count: 0, least_N }
    }

    /// Adds one that is greater than the others, N.
    pub(super) fn push(&mut self, load_N: f64) {
        self.loads_N[self.count] = load_N;
        self.count += 1;
    }

    /// All of them, N.
    pub(super) fn all_N(&self) -> &[f64] {
        &self.loads_N[..self.count]
    }

    /// The one that a compression, N, is compared with.
    pub(super) fn compared_with_N(&self, compression_N: f64) -> f64 {
        let loads_N = self.all_N();
        // Beyond the first it is buckled, beyond the second straight again, beyond the third not.
        let passed = loads_N.iter().filter(|load| **load < compression_N).count();
        let compared = if passed % 2 == 1 { passed - 1 } else { passed };
        loads_N.get(compared).copied().unwrap_or(0.0).max(self.least_N)
    }
}

/// The critical loads of a place by one [`Criterion`](super::Criterion), of the sinusoid and of the
/// helix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BucklingLoads(pub(super) [CriticalLoads; 2]);

impl BucklingLoads {
    /// Those that a compression, N, is compared with: of a pipe that is beyond one the greatest
    /// that it has passed, else the next that it would pass; never less than in a vertical hole.
    /// None where there is no clearance.
    pub fn compared_with_N(&self, compression_N: f64) -> Option<[f64; 2]> {
        let loads_N = self.0.map(|loads| loads.compared_with_N(compression_N));
        loads_N[0].is_finite().then_some(loads_N)
    }
}
