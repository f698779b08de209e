//! Sobol's indices against functions that have them in closed form.

use std::f64::consts::PI;

use wholestring_plan::uncertainty::{Distribution, attribute, latin_hypercube, sampled_indices};
use wholestring_verification::{Row, report_worst, verify};

/// Ishigami and Homma (1990), with 7 and 0.1 as is usual.
const A: f64 = 7.0;
const B: f64 = 0.1;

fn ishigami(x: &[f64]) -> f64 {
    x[0].sin() + A * x[1].sin().powi(2) + B * x[2].powi(4) * x[0].sin()
}

const AROUND: [Distribution; 3] = [Distribution::Uniform { from: -PI, to: PI }; 3];

/// Variance, first-order and total indices of Ishigami's function.
fn exact() -> (f64, [f64; 3], [f64; 3]) {
    let first = 0.5 * (1.0 + B * PI.powi(4) / 5.0).powi(2);
    let second = A * A / 8.0;
    let third = B * B * PI.powi(8) * 8.0 / 225.0;
    let variance = first + second + third;
    let parts = [first, second, 0.0].map(|share| share / variance);
    let totals = [first + third, second, third].map(|share| share / variance);
    (variance, parts, totals)
}

fn rows(
    what: &str,
    found: &[f64],
    expected: &[f64],
    most: f64,
    why: &'static str,
) -> Vec<Row<'static>> {
    let each = found.iter().zip(expected).enumerate();
    each.map(|(input, (found, expected))| {
        let named = format!("{what} of input {}", input + 1);
        verify("uncertainty", named).absolute(most, why).row(*expected, *found)
    })
    .collect()
}

/// By polynomials of a thousand points, and of two hundred; the predicted part shows which to
/// trust.
#[test]
fn ishigami_by_polynomials() {
    let (variance, first, total) = exact();
    let found = |count: usize, seed: u64| {
        let points = latin_hypercube(&AROUND, count, seed);
        let answers: Vec<f64> = points.iter().map(|point| ishigami(point)).collect();
        attribute(&AROUND, &points, &answers).expect("an attribution")
    };
    let many = found(1000, 1);
    assert!(many.predicts > 0.999, "{many:?}");
    let why = "four times the difference between three seeds of 1000 points";
    let mut all = rows("first-order index by polynomials", &many.first, &first, 4e-3, why);
    all.extend(rows("total index by polynomials", &many.total, &total, 4e-3, why));
    all.push(
        verify("uncertainty", "variance of Ishigami's function")
            .relative(0.01, why)
            .row(variance, many.variance),
    );
    let few = found(200, 1);
    assert!(few.predicts < many.predicts && few.degree < many.degree);
    report_worst(all);
}

/// By samples alone, at twenty-five times the cost.
#[test]
fn ishigami_by_samples() {
    let (_, first, total) = exact();
    let found = sampled_indices(&AROUND, 5_000, 1, ishigami);
    let why = "the spread of samples of 5000 points";
    let mut all = rows("first-order index by samples", &found.first, &first, 0.04, why);
    all.extend(rows("total index by samples", &found.total, &total, 0.04, why));
    report_worst(all);
}

/// A sum of inputs of every distribution: each contributes its share of the variance, without
/// interactions. A product of two contributes for both.
#[test]
fn sums_and_products() {
    let inputs = [
        Distribution::Uniform { from: 0.0, to: 6.0 },
        Distribution::Normal { mean: 1.0, std: 2.0 },
        Distribution::Triangular { from: 0.0, mode: 1.0, to: 3.0 },
        Distribution::Uniform { from: 0.0, to: 1.0 },
    ];
    let weights = [1.0, 0.8, 2.0, 0.0];
    let points = latin_hypercube(&inputs, 200, 3);
    let sum = |point: &[f64]| point.iter().zip(weights).map(|(x, weight)| weight * x).sum::<f64>();
    let answers: Vec<f64> = points.iter().map(|point| sum(point)).collect();
    let found = attribute(&inputs, &points, &answers).expect("an attribution");
    let parts: Vec<f64> = inputs
        .iter()
        .zip(weights)
        .map(|(input, weight)| weight * weight * input.variance())
        .collect();
    let variance: f64 = parts.iter().sum();
    let parts: Vec<f64> = parts.iter().map(|part| part / variance).collect();
    let why = "the accuracy of a variance from 200 points";
    let mut all = rows("first-order index of a sum", &found.first, &parts, 5e-3, why);
    all.extend(rows("total index of a sum", &found.total, &parts, 5e-3, why));
    let by_samples = sampled_indices(&inputs, 5_000, 1, sum);
    let why = "the spread of samples of 5000 points";
    all.extend(rows("first-order index of a sum by samples", &by_samples.first, &parts, 0.04, why));

    let pair = [
        Distribution::Normal { mean: 0.0, std: 2.0 },
        Distribution::Normal { mean: 0.0, std: 0.5 },
    ];
    let points = latin_hypercube(&pair, 100, 1);
    let answers: Vec<f64> = points.iter().map(|point| point[0] * point[1]).collect();
    let found = attribute(&pair, &points, &answers).expect("an attribution");
    let why = "rounding";
    all.extend(rows("first-order index of a product", &found.first, &[0.0, 0.0], 1e-9, why));
    all.extend(rows("total index of a product", &found.total, &[1.0, 1.0], 1e-9, why));
    report_worst(all);
}

#[test]
fn what_tells_nothing() {
    let points = latin_hypercube(&AROUND, 100, 1);
    assert_eq!(attribute(&AROUND, &points, &[2.0; 100]), None);
    assert_eq!(attribute(&AROUND, &points[..7], &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]), None);
    let holes: Vec<f64> = points
        .iter()
        .enumerate()
        .map(|(row, point)| if row % 3 == 0 { f64::NAN } else { point[0] })
        .collect();
    let found = attribute(&AROUND, &points, &holes).expect("of the others");
    assert!((found.first[0] - 1.0).abs() < 1e-9, "{found:?}");
}

/// A linear result with a choice among many that shifts it at random, and one among three: shares
/// in closed form.
#[test]
fn choices_have_their_shares() {
    // Mid-points of equal parts: as even as a sample can be, so that shares are nearly exact.
    let inputs = [
        Distribution::Uniform { from: 0.0, to: 1.0 },
        Distribution::Choice { count: 3 },
        Distribution::Choice { count: 400 },
    ];
    let points = latin_hypercube(&inputs, 400, 3);
    // Three values in no order, and 400 shifts that are spread evenly and shuffled.
    let three = [0.3, 0.9, 0.0];
    let stirred = |number: f64| ((number * 271.0) % 400.0 + 0.5) / 400.0;
    let answer = |point: &Vec<f64>| point[0] + three[point[1] as usize] + 0.8 * stirred(point[2]);
    let answers: Vec<f64> = points.iter().map(answer).collect();
    let found = attribute(&inputs, &points, &answers).expect("an attribution");
    let variances = [1.0 / 12.0, 0.14, 0.64 / 12.0];
    let all: f64 = variances.iter().sum();
    for (input, variance) in variances.into_iter().enumerate() {
        // The shares of 400 points: four times 0.03, the scatter of ten seeds.
        assert!((found.total[input] - variance / all).abs() < 0.12, "{found:?}");
    }
    assert!((found.first[1] - 0.14 / all).abs() < 0.12, "{found:?}");
    assert!(found.first[2].is_nan(), "{found:?}");
    assert!((found.total.iter().sum::<f64>() - 1.0).abs() < 0.05, "{found:?}");
}
