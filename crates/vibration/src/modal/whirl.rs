//! Modes of a string that rotates, from those of one that does not.

use nalgebra::{Complex, DMatrix, SymmetricEigen};

use super::{chain::Chain, factors::MOTIONS, search::RealMode};

/// Modes of the chain at rest, and how rotation couples them.
#[derive(Debug, Clone)]
pub(super) struct Turning {
    /// Their angular frequencies, rad/s.
    omega: Vec<f64>,
    /// `Φᵀ G Φ`.
    gyroscopic: DMatrix<f64>,
}

/// A mode of the rotating chain.
#[derive(Debug, Clone)]
pub(super) struct TurningMode {
    /// Angular frequency, rad/s.
    pub(super) omega: f64,
    /// Parts of the modes at rest.
    pub(super) parts: Vec<Complex<f64>>,
}

impl Turning {
    /// Those that are stable of some modes.
    pub(super) fn new(chain: &Chain, modes: &[RealMode]) -> Self {
        let tilts = |mode: &RealMode, node: usize| {
            [mode.motion[node * MOTIONS + 3], mode.motion[node * MOTIONS + 4]]
        };
        let gyroscopic = DMatrix::from_fn(modes.len(), modes.len(), |row, column| {
            let sum = |node: usize| {
                let (a, b) = (tilts(&modes[row], node), tilts(&modes[column], node));
                chain.polar_kg_m2[node] * (a[0] * b[1] - a[1] * b[0])
            };
            (0..chain.nodes()).map(sum).sum()
        });
        Self { omega: modes.iter().map(|mode| mode.lambda.max(0.0).sqrt()).collect(), gyroscopic }
    }

    /// The modes at a rotary speed, by rising frequency.
    ///
    /// With `p = ω q` and `r = diag(ω₀) q` the small pencil `ω₀² − ω² + i ω Ω g` is the Hermitian
    /// `ω (p, r) = [[i Ω g, ω₀], [ω₀, 0]] (p, r)`; of each pair `±ω` the positive one is kept.
    pub(super) fn at(&self, rotary_rad_per_s: f64) -> Vec<TurningMode> {
        let modes = self.omega.len();
        let matrix = DMatrix::from_fn(2 * modes, 2 * modes, |row, column| {
            if row < modes && column < modes {
                Complex::new(0.0, rotary_rad_per_s * self.gyroscopic[(row, column)])
            } else if row % modes == column % modes && row != column {
                Complex::new(self.omega[row % modes], 0.0)
            } else {
                Complex::new(0.0, 0.0)
            }
        });
        let eigen = SymmetricEigen::new(matrix);
        let mut found: Vec<TurningMode> = (0..2 * modes)
            .filter(|k| eigen.eigenvalues[*k] > 0.0)
            .map(|k| {
                let omega = eigen.eigenvalues[k];
                let column = eigen.eigenvectors.column(k);
                let length = (0..modes).map(|i| column[i].norm_sqr()).sum::<f64>().sqrt();
                let parts = (0..modes).map(|i| column[i] / length).collect();
                TurningMode { omega, parts }
            })
            .collect();
        found.sort_by(|a, b| a.omega.total_cmp(&b.omega));
        found
    }
}
