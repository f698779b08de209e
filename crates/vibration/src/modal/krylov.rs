//! Natural modes nearest to a frequency, by Lanczos's method in blocks, shifted and inverted.
//!
//! T. Ericsson and A. Ruhe, *The spectral transformation Lanczos method for the numerical solution
//! of large sparse generalized symmetric eigenvalue problems*, Math. Comp. 35 (1980). Every vector
//! is kept orthogonal to all before it, so that no mode is found twice; blocks of two find the
//! double frequencies of a straight string.

use nalgebra::{DMatrix, SymmetricEigen};

use super::{chain::Chain, factors::Factors};
use wholestring::random::Random;

/// Fraction of a vector's length that must remain after orthogonalisation for it to be independent
/// of the others.
const OF_ITS_OWN: f64 = 1e-10;

/// A space of motions that a shift brings forward, and the action of `M^½ (K − σM)⁻¹ M^½` in it.
pub(super) struct Krylov {
    root_mass: Vec<f64>,
    factors: Factors<f64>,
    /// The shift `σ`, rad²/s².
    shift: f64,
    /// Orthonormal.
    basis: Vec<Vec<f64>>,
    /// The operator in the basis but for the block that was added last.
    projected: Vec<Vec<f64>>,
    /// Vectors of the last block.
    width: usize,
    /// Components along each of those of the operator's action on the block before it.
    beyond: Vec<Vec<f64>>,
    random: Random,
}

/// A mode as far as it has been found.
#[derive(Debug, Clone)]
pub(super) struct Ritz {
    /// Square of its angular frequency, rad²/s².
    pub(super) lambda: f64,
    /// Residual, as a fraction of the operator's eigenvalue.
    pub(super) residual: f64,
    /// Parts of the basis vectors.
    pub(super) parts: Vec<f64>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    // Eight sums at a time: one would wait for itself.
    let mut sums = [0.0; 8];
    let (first, second) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = first.remainder().iter().zip(second.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in first.zip(second) {
        for k in 0..8 {
            sums[k] += x[k] * y[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}

fn subtract(from: &mut [f64], part: f64, direction: &[f64]) {
    for (x, y) in from.iter_mut().zip(direction) {
        *x -= part * y;
    }
}

impl Krylov {
    /// Of a chain, about a shift `σ`, from motions to begin with or from chance.
    pub(super) fn new(chain: &Chain, shift: f64, begin: &[Vec<f64>]) -> Self {
        let mut space = Self {
            root_mass: chain.root_mass(),
            factors: chain.shifted(shift),
            shift,
            basis: Vec::new(),
            projected: Vec::new(),
            width: 0,
            beyond: Vec::new(),
            random: Random::new(7),
        };
        for motion in begin {
            let scaled = motion.iter().zip(&space.root_mass).map(|(x, m)| x * m).collect();
            space.admit(scaled);
        }
        if begin.is_empty() {
            space.meet_chance();
            space.meet_chance();
        }
        space
    }

    /// Vectors in the basis.
    pub(super) fn size(&self) -> usize {
        self.basis.len()
    }

    /// Adds a random vector, for modes that the others do not contain.
    pub(super) fn meet_chance(&mut self) {
        let Self { random, root_mass, .. } = self;
        let vector = root_mass.iter().map(|m| if *m > 0.0 { random.signed() } else { 0.0 });
        let vector = vector.collect();
        self.admit(vector);
    }

    /// Adds the part of a vector that is orthogonal to the others.
    fn admit(&mut self, mut vector: Vec<f64>) {
        let before = dot(&vector, &vector).sqrt();
        for _ in 0..2 {
            for direction in &self.basis {
                let part = dot(&vector, direction);
                subtract(&mut vector, part, direction);
            }
        }
        let length = dot(&vector, &vector).sqrt();
        if length > OF_ITS_OWN * before {
            vector.iter_mut().for_each(|x| *x /= length);
            self.basis.push(vector);
            self.width += 1;
        }
    }

    /// Applies the operator to the last block, which gives the next one. Returns whether it
    /// contains a new direction.
    pub(super) fn extend(&mut self) -> bool {
        let block = self.basis.len() - self.width..self.basis.len();
        let mut made = Vec::new();
        for index in block {
            let root_mass = &self.root_mass;
            let mut vector: Vec<f64> =
                self.basis[index].iter().zip(root_mass).map(|(x, m)| x * m).collect();
            self.factors.solve(&mut vector);
            vector.iter_mut().zip(root_mass).for_each(|(x, m)| *x *= m);
            made.push(vector);
        }
        for vector in &made {
            self.projected.push(self.basis.iter().map(|basis| dot(vector, basis)).collect());
        }
        self.width = 0;
        for vector in &made {
            self.admit(vector.clone());
        }
        let added = &self.basis[self.basis.len() - self.width..];
        self.beyond = added
            .iter()
            .map(|added| made.iter().map(|vector| dot(added, vector)).collect())
            .collect();
        self.width > 0
    }

    /// The modes as far as the space has them, those nearest to the shift first.
    pub(super) fn ritz(&self) -> Vec<Ritz> {
        let size = self.projected.len();
        let at = |row: usize, column: usize| {
            let (early, late) = (row.min(column), row.max(column));
            self.projected[late].get(early).copied().unwrap_or(0.0)
        };
        let eigen = SymmetricEigen::new(DMatrix::from_fn(size, size, at));
        let mut found: Vec<Ritz> = (0..size)
            .filter(|k| eigen.eigenvalues[*k] != 0.0)
            .map(|k| {
                let theta = eigen.eigenvalues[k];
                let parts: Vec<f64> = eigen.eigenvectors.column(k).iter().copied().collect();
                let left_of =
                    |column: &Vec<f64>| dot(column, &parts[size - column.len()..]).powi(2);
                let left = self.beyond.iter().map(left_of).sum::<f64>().sqrt();
                Ritz { lambda: self.shift + 1.0 / theta, residual: left / theta.abs(), parts }
            })
            .collect();
        found.sort_by(|a, b| {
            let far = |ritz: &Ritz| (ritz.lambda - self.shift).abs();
            far(a).total_cmp(&far(b))
        });
        found
    }

    /// The motion of a mode, of unit modal mass: `xᵀ M x = 1`.
    pub(super) fn motion(&self, ritz: &Ritz) -> Vec<f64> {
        let mut sum = vec![0.0; self.root_mass.len()];
        for (part, vector) in ritz.parts.iter().zip(&self.basis) {
            subtract(&mut sum, -part, vector);
        }
        for (x, m) in sum.iter_mut().zip(&self.root_mass) {
            *x = if *m > 0.0 { *x / m } else { 0.0 };
        }
        sum
    }
}
