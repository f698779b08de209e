//! Orthonormal polynomials of one input, and which products of them are taken.

use super::Distribution;

/// The input on the axis of its polynomials: standard deviations of a normal one, of another the part
/// that lies below, from −1 to 1.
fn place(of: &Distribution, value: f64) -> f64 {
    match *of {
        Distribution::Normal { mean, std } => (value - mean) / std,
        Distribution::Uniform { from, to } => 2.0 * (value - from) / (to - from) - 1.0,
        Distribution::Triangular { from, mode, to } => {
            let whole = to - from;
            let below = match value < mode {
                true => (value - from).powi(2) / (whole * (mode - from)),
                false => 1.0 - (to - value).powi(2) / (whole * (to - mode).max(f64::MIN_POSITIVE)),
            };
            2.0 * below - 1.0
        }
    }
}

/// Polynomials up to a degree that are orthonormal under the distribution: Hermite's of a normal one,
/// Legendre's of the others.
pub(super) fn polynomials(of: &Distribution, value: f64, degree: usize) -> Vec<f64> {
    let x = place(of, value);
    let is_normal = matches!(of, Distribution::Normal { .. });
    let mut values = vec![1.0, x];
    for n in 1..degree {
        let (last, before) = (values[n], values[n - 1]);
        let order = n as f64;
        values.push(match is_normal {
            true => x * last - order * before,
            false => ((2.0 * order + 1.0) * x * last - order * before) / (order + 1.0),
        });
    }
    values.truncate(degree + 1);
    let mut factorial = 1.0;
    for (n, value) in values.iter_mut().enumerate() {
        let order = n as f64;
        factorial *= order.max(1.0);
        *value *= match is_normal {
            true => 1.0 / f64::sqrt(factorial),
            false => (2.0 * order + 1.0).sqrt(),
        };
    }
    values
}

/// Degrees in each input of all products up to a total degree, the constant first.
pub(super) fn products(inputs: usize, degree: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for _ in 0..inputs {
        all = all
            .into_iter()
            .flat_map(|product| {
                let left = degree - product.iter().sum::<usize>();
                (0..=left).map(move |next| [&product[..], &[next]].concat())
            })
            .collect();
    }
    all.sort_by_key(|product| product.iter().sum::<usize>());
    all
}

/// How many products there are up to a total degree.
pub(super) fn count(inputs: usize, degree: usize) -> usize {
    (1..=degree).fold(1, |count: usize, order| count.saturating_mul(inputs + order) / order)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means of products over many quantiles: one of a polynomial with itself, else zero.
    #[test]
    fn they_are_orthonormal() {
        for (of, tolerance) in [
            (Distribution::Uniform { from: 2.0, to: 5.0 }, 1e-6),
            (Distribution::Triangular { from: 2.0, mode: 2.5, to: 5.0 }, 1e-6),
            // Beyond the last quantile lies much of an eighth moment.
            (Distribution::Normal { mean: 2.0, std: 0.3 }, 0.02),
        ] {
            let count = 200_000;
            let mut sums = [[0.0; 5]; 5];
            for index in 0..count {
                let values = polynomials(&of, of.quantile((index as f64 + 0.5) / count as f64), 4);
                for (row, a) in sums.iter_mut().zip(&values) {
                    for (sum, b) in row.iter_mut().zip(&values) {
                        *sum += a * b / count as f64;
                    }
                }
            }
            for (i, row) in sums.iter().enumerate() {
                for (j, sum) in row.iter().enumerate() {
                    let expected = f64::from(u8::from(i == j));
                    assert!((sum - expected).abs() < tolerance, "{of:?} {i} {j} {sum}");
                }
            }
        }
    }

    #[test]
    fn products_are_counted() {
        for (inputs, degree, expected) in [(1, 3, 4), (3, 2, 10), (5, 3, 56), (2, 0, 1)] {
            let all = products(inputs, degree);
            assert_eq!((all.len(), count(inputs, degree)), (expected, expected));
            assert!(all[0].iter().all(|of| *of == 0));
            assert!(all.iter().all(|of| of.len() == inputs && of.iter().sum::<usize>() <= degree));
        }
    }
}
