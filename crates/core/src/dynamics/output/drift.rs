//! Block averages: how well the mean of an interval of samples is known, and whether it stands
//! still.

/// Blocks that are left at the longest: fewer tell no spread.
const MIN_BLOCKS: usize = 8;

/// Standard errors beyond which a change of a mean is no chance.
pub(in crate::dynamics) const SIGNIFICANT: f64 = 4.0;

/// Part of a quantity's scale below which a drift is of no consequence: half a percent, less than
/// the gauges of a rig tell.
pub(in crate::dynamics) const MATTERS: f64 = 0.005;

/// Standard error of the mean of samples that depend on their neighbours, by block averages.
///
/// Neighbours are averaged in pairs, the pairs in pairs again, as long as eight blocks are left;
/// the largest `s/√n` of `n` blocks with the standard deviation `s` is taken (Flyvbjerg and
/// Petersen 1989). It serves where the correlation time is a hundredth of the stretch or less, and
/// falls short beyond. Theory: `docs/src/theory/statistics.md`.
pub(in crate::dynamics) fn standard_error(samples: &[f64]) -> f64 {
    let mut blocks = samples.to_vec();
    let mut largest: f64 = 0.0;
    loop {
        let n = blocks.len();
        if n < 2 {
            return largest.sqrt();
        }
        let mean = mean(&blocks);
        let squares: f64 = blocks.iter().map(|x| (x - mean).powi(2)).sum();
        largest = largest.max(squares / ((n - 1) * n) as f64);
        if n / 2 < MIN_BLOCKS {
            return largest.sqrt();
        }
        for pair in 0..n / 2 {
            blocks[pair] = 0.5 * (blocks[2 * pair] + blocks[2 * pair + 1]);
        }
        blocks.truncate(n / 2);
    }
}

/// What a stretch of evenly spaced samples does beside scattering.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dynamics) struct Drift {
    /// Change over the stretch by the straight line of least squares.
    pub(in crate::dynamics) change: f64,
    /// How many of its standard errors that is, or the difference of the halves' means of its own,
    /// whichever is more. Zero of so few samples that none is known.
    pub(in crate::dynamics) errors: f64,
}

impl Drift {
    /// Tests samples for drift.
    ///
    /// The line's change has `√12` times the standard error of the mean, which is taken from what
    /// scatters about the line. The means of the halves differ by `√2` standard errors of one; a
    /// start that fades inflates that of the first half, so that the smaller one is taken.
    pub(in crate::dynamics) fn of(samples: &[f64]) -> Self {
        let n = samples.len();
        let half = n / 2;
        let middle = 0.5 * n.saturating_sub(1) as f64;
        let mean_all = mean(samples);
        let moment: f64 = (0..n).map(|i| (i as f64 - middle) * (samples[i] - mean_all)).sum();
        // `Σ (i − (n − 1)/2)²`.
        let square = n as f64 * ((n * n) as f64 - 1.0) / 12.0;
        let slope = if n < 2 { 0.0 } else { moment / square };
        let change = slope * n as f64;
        if half < MIN_BLOCKS {
            return Self { change, errors: 0.0 };
        }
        let about_line: Vec<f64> =
            (0..n).map(|i| samples[i] - slope * (i as f64 - middle)).collect();
        let line_error = 12_f64.sqrt() * standard_error(&about_line);
        let (first, second) = (&samples[..half], &samples[n - half..]);
        let min_error = standard_error(first).min(standard_error(second));
        let halves_error = 2_f64.sqrt() * min_error;
        let over = |change: f64, error: f64| {
            if change == 0.0 { 0.0 } else { (change / error).abs() }
        };
        let between = mean(second) - mean(first);
        Self { change, errors: over(change, line_error).max(over(between, halves_error)) }
    }

    /// Whether it is more than so many standard errors and more than `least`.
    pub(in crate::dynamics) fn exceeds(&self, errors: f64, least: f64) -> bool {
        self.errors > errors && self.change.abs() > least
    }
}

/// The mean; zero of nothing.
pub(in crate::dynamics) fn mean(samples: &[f64]) -> f64 {
    samples.iter().sum::<f64>() / samples.len().max(1) as f64
}

#[cfg(test)]
mod tests;
