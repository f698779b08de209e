//! A block-tridiagonal system of linear equations, as of a chain of elements.

use nalgebra::{SMatrix, SVector};

/// Unknowns of a node: displacement along the hole's axes, and the director's two angles.
pub(super) const UNKNOWNS: usize = 5;

/// Derivative of a node's forces with respect to a node's displacements.
pub(super) type Block = SMatrix<f64, UNKNOWNS, UNKNOWNS>;

/// A number for each unknown of a node.
pub(super) type Entry = SVector<f64, UNKNOWNS>;

/// The matrix, by block rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Tridiagonal {
    /// On the diagonal.
    pub(super) diagonal: Vec<Block>,
    /// Right of it: a row less.
    pub(super) upper: Vec<Block>,
    /// Below it: of row `i + 1`, column `i`.
    pub(super) lower: Vec<Block>,
}

/// No pivot is left in a block row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Singular {
    /// The row.
    pub(super) row: usize,
}

impl Tridiagonal {
    /// A matrix of this many block rows, all zero.
    pub(super) fn zeros(rows: usize) -> Self {
        let zeros = |rows: usize| vec![Block::zeros(); rows];
        Self { diagonal: zeros(rows), upper: zeros(rows - 1), lower: zeros(rows - 1) }
    }

    /// Sets every entry to zero.
    pub(super) fn clear(&mut self) {
        for blocks in [&mut self.diagonal, &mut self.upper, &mut self.lower] {
            blocks.fill(Block::zeros());
        }
    }

    /// Eliminates the unknown `k` of a block row: its equation sets it to the right-hand side.
    pub(super) fn hold(&mut self, row: usize, k: usize) {
        self.diagonal[row].row_mut(k).fill(0.0);
        self.diagonal[row].column_mut(k).fill(0.0);
        self.diagonal[row][(k, k)] = 1.0;
        if row < self.upper.len() {
            self.upper[row].row_mut(k).fill(0.0);
            self.lower[row].column_mut(k).fill(0.0);
        }
        if let Some(above) = row.checked_sub(1) {
            self.upper[above].column_mut(k).fill(0.0);
            self.lower[above].row_mut(k).fill(0.0);
        }
    }

    /// Solves for a right-hand side in place, by block elimination with row exchanges within
    /// blocks. The matrix is overwritten.
    pub(super) fn solve(&mut self, rhs: &mut [Entry]) -> Result<(), Singular> {
        let rows = self.diagonal.len();
        for row in 0..rows {
            if row > 0 {
                // The row above has become x + (its upper) x' = (its right-hand side).
                let lower = self.lower[row - 1];
                self.diagonal[row] -= lower * self.upper[row - 1];
                let above = rhs[row - 1];
                rhs[row] -= lower * above;
            }
            let mut none = Block::zeros();
            let upper = if row + 1 < rows { &mut self.upper[row] } else { &mut none };
            eliminate(&mut self.diagonal[row], upper, &mut rhs[row]).ok_or(Singular { row })?;
        }
        for row in (0..rows - 1).rev() {
            let below = rhs[row + 1];
            rhs[row] -= self.upper[row] * below;
        }
        Ok(())
    }

    /// Whether the matrix, which is symmetric, is positive definite with `shift` added to its
    /// diagonal, that is, whether Cholesky factors of every block exist. Lower blocks are not read.
    pub(super) fn is_positive_definite(&self, shift: &Entry) -> bool {
        let shift = Block::from_diagonal(shift);
        let mut above = Block::zeros();
        for (row, diagonal) in self.diagonal.iter().enumerate() {
            let Some(factor) = cholesky(diagonal + shift - above) else { return false };
            let Some(upper) = self.upper.get(row) else { break };
            let halved = forwards(&factor, *upper);
            above = halved.tr_mul(&halved);
        }
        true
    }
}

/// Computes the Cholesky factor of a block, with the inverse of its diagonal in place of the
/// diagonal; none where the block is not positive definite. Entries above the diagonal are not
/// read.
fn cholesky(mut block: Block) -> Option<Block> {
    for column in 0..UNKNOWNS {
        let mut pivot = block[(column, column)];
        for k in 0..column {
            pivot -= block[(column, k)] * block[(column, k)];
        }
        if !(pivot > 0.0 && pivot.is_finite()) {
            return None;
        }
        let over = 1.0 / pivot.sqrt();
        block[(column, column)] = over;
        for row in column + 1..UNKNOWNS {
            let mut entry = block[(row, column)];
            for k in 0..column {
                entry -= block[(row, k)] * block[(column, k)];
            }
            block[(row, column)] = entry * over;
        }
    }
    Some(block)
}

/// Solves `L x = block` for a Cholesky factor `L`.
fn forwards(factor: &Block, mut block: Block) -> Block {
    for column in 0..UNKNOWNS {
        for row in 0..UNKNOWNS {
            let mut entry = block[(row, column)];
            for k in 0..row {
                entry -= factor[(row, k)] * block[(k, column)];
            }
            block[(row, column)] = entry * factor[(row, row)];
        }
    }
    block
}

/// Turns `matrix x + upper x' = rhs` into `x + upper' x' = rhs'`, by Gaussian elimination with
/// partial pivoting; none where no pivot is left.
fn eliminate(matrix: &mut Block, upper: &mut Block, rhs: &mut Entry) -> Option<()> {
    for column in 0..UNKNOWNS {
        let pivot_row = (column..UNKNOWNS)
            .max_by(|a, b| matrix[(*a, column)].abs().total_cmp(&matrix[(*b, column)].abs()))?;
        let pivot = matrix[(pivot_row, column)];
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        if pivot_row != column {
            matrix.swap_rows(pivot_row, column);
            upper.swap_rows(pivot_row, column);
            rhs.swap_rows(pivot_row, column);
        }
        let inverse = 1.0 / pivot;
        for row in column + 1..UNKNOWNS {
            let factor = matrix[(row, column)] * inverse;
            if factor != 0.0 {
                for k in column + 1..UNKNOWNS {
                    matrix[(row, k)] -= factor * matrix[(column, k)];
                }
                for k in 0..UNKNOWNS {
                    upper[(row, k)] -= factor * upper[(column, k)];
                }
                rhs[row] -= factor * rhs[column];
            }
        }
    }
    for row in (0..UNKNOWNS).rev() {
        let inverse = 1.0 / matrix[(row, row)];
        for k in row + 1..UNKNOWNS {
            let factor = matrix[(row, k)];
            for j in 0..UNKNOWNS {
                let below = upper[(k, j)];
                upper[(row, j)] -= factor * below;
            }
            let below = rhs[k];
            rhs[row] -= factor * below;
        }
        for j in 0..UNKNOWNS {
            upper[(row, j)] *= inverse;
        }
        rhs[row] *= inverse;
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::*;
    use crate::random::Random;

    /// A system without symmetry whose blocks need row exchanges, compared with nalgebra's general
    /// LU of the whole matrix: only rounding remains, 1e-16 times a condition of some thousands.
    #[test]
    fn solves_what_a_general_solver_solves() {
        const ROWS: usize = 12;
        let mut random = Random::new(3);
        let mut system = Tridiagonal::zeros(ROWS);
        let mut fill = |block: &mut Block| block.iter_mut().for_each(|x| *x = random.signed());
        system.diagonal.iter_mut().for_each(&mut fill);
        system.upper.iter_mut().for_each(&mut fill);
        system.lower.iter_mut().for_each(&mut fill);
        let mut rhs: Vec<Entry> = (0..ROWS)
            .map(|row| Entry::from_fn(|k, _| (row as f64 + 0.3 * k as f64).sin()))
            .collect();
        let mut whole = DMatrix::zeros(ROWS * UNKNOWNS, ROWS * UNKNOWNS);
        let mut put = |row: usize, column: usize, block: &Block| {
            whole
                .view_mut((row * UNKNOWNS, column * UNKNOWNS), (UNKNOWNS, UNKNOWNS))
                .copy_from(block);
        };
        for row in 0..ROWS {
            put(row, row, &system.diagonal[row]);
            if row + 1 < ROWS {
                put(row, row + 1, &system.upper[row]);
                put(row + 1, row, &system.lower[row]);
            }
        }
        let right = DVector::from_iterator(ROWS * UNKNOWNS, rhs.iter().flatten().copied());
        let expected = whole.lu().solve(&right).expect("a solution");
        system.solve(&mut rhs).expect("pivots");
        for (found, expected) in rhs.iter().flatten().zip(expected.iter()) {
            assert!(
                (found - expected).abs() < 1e-9 * expected.abs().max(1.0),
                "{found} {expected}"
            );
        }
    }

    /// A chain of springs is positive definite. It is not where one spring pushes more than its
    /// neighbours can balance, and a row of zeros has no pivot.
    #[test]
    fn tells_a_stable_chain_from_an_unstable_one() {
        let chain = |middle: f64| {
            let mut system = Tridiagonal::zeros(5);
            for row in 0..5 {
                system.diagonal[row] = Block::identity() * if row == 2 { middle } else { 2.0 };
            }
            for off in 0..4 {
                system.upper[off] = -Block::identity();
                system.lower[off] = -Block::identity();
            }
            system
        };
        // The pivot of the middle is `middle − 4/3` of its two sides.
        assert!(chain(1.34).is_positive_definite(&Entry::zeros()));
        assert!(!chain(1.33).is_positive_definite(&Entry::zeros()));
        assert!(chain(1.33).is_positive_definite(&Entry::repeat(0.01)));
        let mut nothing = Tridiagonal::zeros(3);
        nothing.diagonal[0] = Block::identity();
        let solved = nothing.solve(&mut [Entry::zeros(); 3]);
        assert_eq!(solved, Err(Singular { row: 1 }));
    }
}
