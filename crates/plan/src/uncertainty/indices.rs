//! Sobol's indices from samples alone.

use super::{Distribution, latin_hypercube};

/// Parts of a result's variance by input.
#[derive(Debug, Clone, PartialEq)]
pub struct Indices {
    /// First-order: the part that would vanish if the input were known.
    pub first: Vec<f64>,
    /// Total: the part that would remain if all others were known.
    pub total: Vec<f64>,
}

/// Returns Sobol's indices of a result that is cheap to compute: `count (inputs + 2)` evaluations,
/// with the estimators of Saltelli and others (2010) for the first order and of Jansen (1999) for
/// the total.
pub fn sampled_indices(
    inputs: &[Distribution],
    count: usize,
    seed: u64,
    function: impl Fn(&[f64]) -> f64,
) -> Indices {
    let twice: Vec<Distribution> = inputs.iter().chain(inputs).copied().collect();
    // Both samples from one hypercube, so that they are independent of each other.
    let points = latin_hypercube(&twice, count, seed);
    let (a, b): (Vec<&[f64]>, Vec<&[f64]>) =
        points.iter().map(|point| point.split_at(inputs.len())).unzip();
    let answers =
        |points: &[&[f64]]| points.iter().map(|point| function(point)).collect::<Vec<f64>>();
    let (of_a, of_b) = (answers(&a), answers(&b));
    let all = of_a.iter().chain(&of_b);
    let mean = all.clone().sum::<f64>() / (2 * count) as f64;
    let variance = all.map(|answer| (answer - mean).powi(2)).sum::<f64>() / (2 * count) as f64;
    let mut indices = Indices { first: Vec::new(), total: Vec::new() };
    for input in 0..inputs.len() {
        let (mut first, mut total) = (0.0, 0.0);
        for row in 0..count {
            let mut mixed = a[row].to_vec();
            mixed[input] = b[row][input];
            let mixed = function(&mixed);
            first += (of_b[row] - mean) * (mixed - of_a[row]);
            total += (of_a[row] - mixed).powi(2);
        }
        indices.first.push(first / (count as f64 * variance));
        indices.total.push(total / (2.0 * count as f64 * variance));
    }
    indices
}
