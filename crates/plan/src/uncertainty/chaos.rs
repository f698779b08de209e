//! Sobol's indices from polynomials that are fitted to the results: polynomial chaos (Sudret 2008).

use nalgebra::{DMatrix, DVector};

use super::{
    Distribution, latin_hypercube,
    polynomials::{count, highest, polynomials, products},
};

/// Highest degree that is tried.
const HIGHEST: usize = 10;

/// Points for each polynomial, at least.
const POINTS: usize = 2;

/// Relative difference from their mean up to which results are the same: rounding.
const SAME: f64 = 1e-9;

/// Gain of the predicted part of the variance that a higher degree requires.
const BETTER: f64 = 1e-3;

/// Contributions of the inputs to the variance of a result.
#[derive(Debug, Clone, PartialEq)]
pub struct Attribution {
    /// Mean of the result.
    pub mean: f64,
    /// Its variance.
    pub variance: f64,
    /// First-order index of each input: the part of the variance that would vanish if it were
    /// known. NaN for a choice among more than four values.
    pub first: Vec<f64>,
    /// Total index of each input: the part that would remain if all others were known. For a choice
    /// among more than four values, the whole part that the polynomials of the others do not
    /// predict.
    pub total: Vec<f64>,
    /// The part of the variance that the polynomials predict at points that they were not fitted
    /// to: one less the mean square of the leave-one-out errors over the variance. Indices of a fit
    /// that predicts less than 0.9 are unreliable, unless a choice among many values accounts for
    /// the rest.
    pub predicts: f64,
    /// Degree of the polynomials.
    pub degree: usize,
}

/// Returns the contributions of inputs to the variance of results: `points` have a value of each
/// input, `answers` one result each; values that are not finite are ignored. The degree is the
/// lowest that predicts about as much as any that the points suffice for, two for each polynomial.
/// `None` where there are not enough points for a degree of one, or the results do not vary.
pub fn attribute(
    inputs: &[Distribution],
    points: &[Vec<f64>],
    answers: &[f64],
) -> Option<Attribution> {
    let finite = points.iter().zip(answers).filter(|(_, answer)| answer.is_finite());
    let (points, answers): (Vec<&Vec<f64>>, Vec<f64>) = finite.unzip();
    let rows = points.len();
    let mean = answers.iter().sum::<f64>() / rows.max(1) as f64;
    let square = answers.iter().map(|answer| (answer - mean).powi(2)).sum::<f64>();
    let varies = square > (SAME * mean).powi(2) * rows as f64;
    if inputs.is_empty() || !varies {
        return None;
    }
    let answers = DVector::from_vec(answers);
    let mut best: Option<Attribution> = None;
    for degree in 1..=HIGHEST {
        if count(inputs.len(), degree) * POINTS > rows {
            break;
        }
        let Some(found) = fitted(inputs, &points, &answers, degree, square) else { continue };
        if best.as_ref().is_none_or(|best| found.predicts > best.predicts + BETTER) {
            best = Some(found);
        }
    }
    best
}

/// Returns the least-squares fit of one degree.
fn fitted(
    inputs: &[Distribution],
    points: &[&Vec<f64>],
    answers: &DVector<f64>,
    degree: usize,
    square: f64,
) -> Option<Attribution> {
    let mut products = products(inputs.len(), degree);
    let highest: Vec<usize> = inputs.iter().map(highest).collect();
    products.retain(|product| product.iter().zip(&highest).all(|(order, most)| order <= most));
    let rows = points.len();
    let mut matrix = DMatrix::zeros(rows, products.len());
    for (row, point) in points.iter().enumerate() {
        let each: Vec<Vec<f64>> = inputs
            .iter()
            .zip(point.iter())
            .map(|(input, value)| polynomials(input, *value, degree))
            .collect();
        for (column, product) in products.iter().enumerate() {
            let factors = product.iter().zip(&each).map(|(order, values)| values[*order]);
            matrix[(row, column)] = factors.product();
        }
    }
    let qr = matrix.qr();
    let (q, r) = (qr.q(), qr.r());
    let projected = q.transpose() * answers;
    let coefficients = r.solve_upper_triangular(&projected)?;
    let fit = &q * projected;
    // Leave-one-out errors, from the diagonal of the hat matrix `Q Qᵀ`.
    let left_out: f64 = (0..rows)
        .map(|row| {
            let leverage = q.row(row).norm_squared();
            ((answers[row] - fit[row]) / (1.0 - leverage).max(f64::EPSILON)).powi(2)
        })
        .sum();
    let variance: f64 =
        coefficients.iter().skip(1).map(|coefficient| coefficient * coefficient).sum();
    let predicts = 1.0 - left_out / square;
    // The part that no polynomial predicts is attributed to the choices without polynomials.
    let has_rest = highest.contains(&0);
    let rest = if has_rest { (1.0 - predicts).clamp(0.0, 1.0) } else { 0.0 };
    let part = |holds: &dyn Fn(&[usize]) -> bool| {
        let held = products.iter().zip(coefficients.iter()).skip(1);
        let held = held.filter(|(product, _)| holds(product));
        let held: f64 = held.map(|(_, coefficient)| coefficient * coefficient).sum();
        if variance > 0.0 { (1.0 - rest) * held / variance } else { 0.0 }
    };
    let alone = |input: usize| {
        move |product: &[usize]| {
            let mut orders = product.iter().enumerate();
            orders.all(|(place, order)| (place == input) == (*order > 0))
        }
    };
    let first = |input: usize| match highest[input] {
        0 => f64::NAN,
        _ => part(&alone(input)),
    };
    let total = |input: usize| match highest[input] {
        0 => rest,
        _ => part(&|product| product[input] > 0),
    };
    Some(Attribution {
        mean: coefficients[0],
        variance: if has_rest { square / rows as f64 } else { variance },
        first: (0..inputs.len()).map(first).collect(),
        total: (0..inputs.len()).map(total).collect(),
        predicts,
        degree,
    })
}

// Sobol's indices from samples alone.

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
