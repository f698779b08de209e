//! The critical loads of a place, of which each compression is compared with one.

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
