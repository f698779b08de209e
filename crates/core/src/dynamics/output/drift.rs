//! Block averages: standard error of the mean of an interval of samples, and test for a drift.

use crate::outcome::samples::{Mapped, Part, Samples, mean, sum};

/// Number of blocks at the greatest block length: fewer do not determine the spread.
const MIN_BLOCKS: usize = 8;

/// Standard errors beyond which a change of a mean is no chance.
pub(in crate::dynamics) const SIGNIFICANT: f64 = 4.0;

/// Part of a quantity's scale below which a drift is of no consequence: half a percent, less than
/// the gauges of a rig resolve.
pub(in crate::dynamics) const MATTERS: f64 = 0.005;

/// Standard error of the mean of samples that depend on their neighbours, by block averages.
///
/// Neighbours are averaged in pairs, the pairs in pairs again, as long as eight blocks are left;
/// the largest `s/√n` of `n` blocks with the standard deviation `s` is taken (Flyvbjerg and
/// Petersen 1989). It serves where the correlation time is a hundredth of the stretch or less, and
/// falls short beyond. Theory: `docs/src/theory/statistics.md`.
pub(in crate::dynamics) fn standard_error(samples: &(impl Samples + ?Sized)) -> f64 {
    let counts = block_counts(samples.count());
    let mut means = vec![-0.0; counts.len()];
    each_block(samples, counts.len(), |level, block| means[level] += block);
    for (mean, count) in means.iter_mut().zip(&counts) {
        *mean /= *count as f64;
    }
    let mut squares = vec![-0.0; counts.len()];
    each_block(samples, counts.len(), |level, block| {
        squares[level] += (block - means[level]).powi(2);
    });
    let errors = squares.iter().zip(counts).map(|(squares, n)| squares / ((n - 1) * n) as f64);
    errors.fold(0.0, f64::max).sqrt()
}

/// Numbers of blocks of one sample, of two, of four, as long as eight are left.
fn block_counts(samples: usize) -> Vec<usize> {
    let halved = |count: &usize| Some(count / 2).filter(|half| *half >= MIN_BLOCKS);
    std::iter::successors(Some(samples).filter(|count| *count >= 2), halved).collect()
}

/// Calls `take` with the mean of each block, of one sample at the level zero, of two at the next.
/// Of each level one block waits for its neighbour.
fn each_block(samples: &(impl Samples + ?Sized), levels: usize, mut take: impl FnMut(usize, f64)) {
    let mut waiting = vec![None; levels];
    samples.each(&mut |values| {
        for value in values {
            let mut block = *value;
            for (level, waiting) in waiting.iter_mut().enumerate() {
                take(level, block);
                match waiting.take() {
                    Some(before) => block = 0.5 * (before + block),
                    None => {
                        *waiting = Some(block);
                        break;
                    }
                }
            }
        }
    });
}

/// Drift of a stretch of evenly spaced samples, apart from their scatter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dynamics) struct Drift {
    /// Change over the stretch by the straight line of least squares.
    pub(in crate::dynamics) change: f64,
    /// The drift in its standard errors, or the difference of the halves' means of its own,
    /// whichever is more. Zero where the samples are too few for an error.
    pub(in crate::dynamics) errors: f64,
}

impl Drift {
    /// Tests samples for drift.
    ///
    /// The line's change has `√12` times the standard error of the mean, which is computed from the
    /// scatter about the line. The means of the halves differ by `√2` standard errors of one; a
    /// start that fades inflates that of the first half, so that the smaller one is taken.
    pub(in crate::dynamics) fn of(samples: &(impl Samples + ?Sized)) -> Self {
        let n = samples.count();
        let half = n / 2;
        let middle = 0.5 * n.saturating_sub(1) as f64;
        let mean_all = mean(samples);
        let moment = sum(samples, |i, sample| (i as f64 - middle) * (sample - mean_all));
        // `Σ (i − (n − 1)/2)²`.
        let square = n as f64 * ((n * n) as f64 - 1.0) / 12.0;
        let slope = if n < 2 { 0.0 } else { moment / square };
        let change = slope * n as f64;
        if half < MIN_BLOCKS {
            return Self { change, errors: 0.0 };
        }
        let value = |i: usize, sample: f64| sample - slope * (i as f64 - middle);
        let line_error = 12_f64.sqrt() * standard_error(&Mapped { samples, value });
        let [first, second] = [0..half, n - half..n].map(|rows| Part { samples, rows });
        let min_error = standard_error(&first).min(standard_error(&second));
        let halves_error = 2_f64.sqrt() * min_error;
        let over = |change: f64, error: f64| {
            if change == 0.0 { 0.0 } else { (change / error).abs() }
        };
        let between = mean(&second) - mean(&first);
        Self { change, errors: over(change, line_error).max(over(between, halves_error)) }
    }

    /// Whether it is more than so many standard errors and more than `least`.
    pub(in crate::dynamics) fn exceeds(&self, errors: f64, least: f64) -> bool {
        self.errors > errors && self.change.abs() > least
    }
}

#[cfg(test)]
mod tests;
