//! Orthonormal polynomials of one input, and the products of them.

use super::Distribution;

/// Maximum number of values of a choice for which polynomials can represent any function: with
/// more, too many points would be needed.
const FEW: usize = 4;

/// Returns the highest degree of an input. A choice among many values, whose order may be
/// meaningless, has none: the polynomials do not represent its contribution.
pub(super) fn highest(distribution: &Distribution) -> usize {
    match *distribution {
        Distribution::Choice { count } if count <= FEW => count - 1,
        Distribution::Choice { .. } => 0,
        _ => usize::MAX,
    }
}

/// Returns polynomials up to a degree that are orthonormal under the distribution: Hermite's for a
/// normal and a log-normal one, Gram's for a choice, Legendre's of the part below for the others.
pub(super) fn polynomials(distribution: &Distribution, value: f64, degree: usize) -> Vec<f64> {
    match *distribution {
        Distribution::Normal { mean, std } => hermite((value - mean) / std, degree),
        Distribution::LogNormal { median, factor } => {
            hermite(libm::log(value / median) / libm::log(factor), degree)
        }
        Distribution::Choice { count } => gram(value, count as f64, degree),
        Distribution::Uniform { .. }
        | Distribution::Triangular { .. }
        | Distribution::TruncatedNormal { .. } => {
            legendre(2.0 * distribution.below(value) - 1.0, degree)
        }
    }
}

/// Returns polynomials from a recurrence: for an order `n`, the value before last and the last give
/// the next; the other function is the mean square of an order.
fn by_recurrence(
    first: f64,
    degree: usize,
    next: impl Fn(f64, f64, f64) -> f64,
    square: impl Fn(f64, f64) -> f64,
) -> Vec<f64> {
    let mut values = vec![1.0, first];
    for n in 1..degree {
        values.push(next(n as f64, values[n - 1], values[n]));
    }
    values.truncate(degree + 1);
    let mut mean_square = 1.0;
    for (n, value) in values.iter_mut().enumerate() {
        mean_square = square(n as f64, mean_square);
        *value = if mean_square > 0.0 { *value / mean_square.sqrt() } else { 0.0 };
    }
    values
}

fn hermite(x: f64, degree: usize) -> Vec<f64> {
    by_recurrence(x, degree, |n, before, last| x * last - n * before, |n, last| last * n.max(1.0))
}

fn legendre(x: f64, degree: usize) -> Vec<f64> {
    let next =
        |n: f64, before: f64, last: f64| ((2.0 * n + 1.0) * x * last - n * before) / (n + 1.0);
    by_recurrence(x, degree, next, |n, _| 1.0 / (2.0 * n + 1.0))
}

/// Returns the polynomials of the numbers 0 to `count - 1`, equally likely.
fn gram(value: f64, count: f64, degree: usize) -> Vec<f64> {
    let x = value - 0.5 * (count - 1.0);
    let weight = |n: f64| {
        let square = n * n;
        (square * (count * count - square) / (4.0 * (4.0 * square - 1.0))).max(0.0)
    };
    let next = |n: f64, before: f64, last: f64| x * last - weight(n) * before;
    by_recurrence(x, degree, next, |n, last| if n > 0.0 { last * weight(n) } else { last })
}

/// Returns the degrees in each input of all products up to a total degree, the constant first.
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

/// Returns the number of products up to a total degree.
pub(super) fn count(inputs: usize, degree: usize) -> usize {
    (1..=degree).fold(1, |count: usize, order| count.saturating_mul(inputs + order) / order)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means of products over many quantiles: one of a polynomial with itself, else zero.
    #[test]
    fn they_are_orthonormal() {
        for (distribution, tolerance) in [
            (Distribution::Uniform { from: 2.0, to: 5.0 }, 1e-6),
            (Distribution::Triangular { from: 2.0, mode: 2.5, to: 5.0 }, 1e-6),
            (Distribution::TruncatedNormal { mean: 0.0, std: 1.0, from: -0.5, to: 2.0 }, 1e-6),
            (Distribution::Choice { count: 5 }, 1e-6),
            // A large part of an eighth moment is beyond the last quantile.
            (Distribution::Normal { mean: 2.0, std: 0.3 }, 0.02),
            (Distribution::LogNormal { median: 2.0, factor: 1.3 }, 0.02),
        ] {
            let count = 200_000;
            let mut sums = [[0.0; 5]; 5];
            for index in 0..count {
                let values = polynomials(
                    &distribution,
                    distribution.quantile((index as f64 + 0.5) / count as f64),
                    4,
                );
                for (row, a) in sums.iter_mut().zip(&values) {
                    for (sum, b) in row.iter_mut().zip(&values) {
                        *sum += a * b / count as f64;
                    }
                }
            }
            for (i, row) in sums.iter().enumerate() {
                for (j, sum) in row.iter().enumerate() {
                    let expected = f64::from(u8::from(i == j));
                    assert!((sum - expected).abs() < tolerance, "{distribution:?} {i} {j} {sum}");
                }
            }
        }
    }

    #[test]
    fn products_are_counted() {
        for (inputs, degree, expected) in [(1, 3, 4), (3, 2, 10), (5, 3, 56), (2, 0, 1)] {
            let all = products(inputs, degree);
            assert_eq!((all.len(), count(inputs, degree)), (expected, expected));
            assert!(all[0].iter().all(|degrees| *degrees == 0));
            assert!(
                all.iter()
                    .all(|degrees| degrees.len() == inputs
                        && degrees.iter().sum::<usize>() <= degree)
            );
        }
    }
}
