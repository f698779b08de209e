//! Factors of a Hermitian block-tridiagonal matrix, and how many of its eigenvalues are negative.

use nalgebra::{ComplexField, SMatrix};

/// Motions of a node: displacement along two directions across the hole and along it, rotation
/// about two directions across the string and about it.
pub(super) const MOTIONS: usize = 6;

/// Derivative of a node's forces with respect to a node's motion.
pub(super) type Stiffness = SMatrix<f64, MOTIONS, MOTIONS>;

/// Pivots smaller than this fraction of the original value in their place are replaced by it: the
/// matrix is singular to rounding.
const SINGULAR: f64 = 1e-15;

/// A block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<T>(pub(super) [[T; MOTIONS]; MOTIONS]);

impl<T: ComplexField<RealField = f64> + Copy> Block<T> {
    pub(super) fn from_fn(entry: impl Fn(usize, usize) -> T) -> Self {
        Self(std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column))))
    }

    /// Inverts a Hermitian block in place, choosing the largest pivots relative to the original
    /// values. Returns the number of negative pivots, which is that of negative eigenvalues.
    fn invert(&mut self, scale: &[f64; MOTIONS]) -> usize {
        let a = &mut self.0;
        let mut negative = 0;
        let mut left = [true; MOTIONS];
        for _ in 0..MOTIONS {
            let size = |k: &usize| a[*k][*k].real().abs() / scale[*k];
            let candidates = (0..MOTIONS).filter(|k| left[*k]);
            let Some(k) = candidates.max_by(|i, j| size(i).total_cmp(&size(j))) else { break };
            left[k] = false;
            let mut pivot = a[k][k].real();
            negative += usize::from(pivot < 0.0);
            let least = SINGULAR * scale[k];
            if pivot.abs() < least {
                pivot = least.copysign(pivot);
            }
            a[k][k] = T::one();
            let row: [T; MOTIONS] = a[k].map(|x| x.unscale(pivot));
            a[k] = row;
            for i in (0..MOTIONS).filter(|i| *i != k) {
                let factor = a[i][k];
                a[i][k] = T::zero();
                for j in 0..MOTIONS {
                    a[i][j] -= factor * row[j];
                }
            }
        }
        negative
    }

    /// This times a real one.
    fn times(&self, stiffness: &Stiffness) -> Self {
        let mut product = [[T::zero(); MOTIONS]; MOTIONS];
        for (sums, own) in product.iter_mut().zip(&self.0) {
            for (k, part) in own.iter().enumerate() {
                for (column, sum) in sums.iter_mut().enumerate() {
                    *sum += part.scale(stiffness[(k, column)]);
                }
            }
        }
        Self(product)
    }

    /// Less the transpose of a real one times another.
    fn less_transpose_times(&mut self, stiffness: &Stiffness, other: &Self) {
        for k in 0..MOTIONS {
            for row in 0..MOTIONS {
                for column in 0..MOTIONS {
                    self.0[row][column] -= other.0[k][column].scale(stiffness[(k, row)]);
                }
            }
        }
    }
}

/// Factors of a Hermitian matrix with real blocks next to those of its diagonal.
#[derive(Debug, Clone)]
pub(super) struct Factors<T> {
    /// Inverse pivots.
    inverse: Vec<Block<T>>,
    /// Inverse pivots times the blocks to the right.
    coupling: Vec<Block<T>>,
    /// Negative eigenvalues of the matrix, by Sylvester's law of inertia.
    pub(super) negative: usize,
}

impl<T: ComplexField<RealField = f64> + Copy> Factors<T> {
    pub(super) fn new(diagonal: impl Iterator<Item = Block<T>>, upper: &[Stiffness]) -> Self {
        let mut factors = Self {
            inverse: Vec::with_capacity(upper.len() + 1),
            coupling: Vec::with_capacity(upper.len()),
            negative: 0,
        };
        for (row, mut pivot) in diagonal.enumerate() {
            let scale = std::array::from_fn(|k| pivot.0[k][k].real().abs().max(f64::MIN_POSITIVE));
            if let Some(above) = row.checked_sub(1) {
                pivot.less_transpose_times(&upper[above], &factors.coupling[above]);
            }
            factors.negative += pivot.invert(&scale);
            if let Some(right) = upper.get(row) {
                factors.coupling.push(pivot.times(right));
            }
            factors.inverse.push(pivot);
        }
        factors
    }

    /// Solves in place; six numbers a node.
    pub(super) fn solve(&self, rhs: &mut [T]) {
        let nodes = self.inverse.len();
        for node in 1..nodes {
            let (before, own) = rhs[(node - 1) * MOTIONS..].split_at_mut(MOTIONS);
            let coupling = &self.coupling[node - 1].0;
            for (k, from) in before.iter().enumerate() {
                for row in 0..MOTIONS {
                    own[row] -= coupling[k][row].conjugate() * *from;
                }
            }
        }
        for node in (0..nodes).rev() {
            let (own, after) = rhs[node * MOTIONS..].split_at_mut(MOTIONS);
            let mut solved = [T::zero(); MOTIONS];
            for (row, found) in solved.iter_mut().enumerate() {
                for (part, x) in self.inverse[node].0[row].iter().zip(&*own) {
                    *found += *part * *x;
                }
                if let Some(coupling) = self.coupling.get(node) {
                    for (part, x) in coupling.0[row].iter().zip(&*after) {
                        *found -= *part * *x;
                    }
                }
            }
            own.copy_from_slice(&solved);
        }
    }
}
