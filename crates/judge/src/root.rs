//! Zero of a function of one variable.

/// Largest number of steps: a zero of any function is found within it, because bisection of a range
/// of 1e5 to 1e-10 takes 50.
const STEPS: usize = 200;

/// Returns the place at which a function changes sign between two places where its signs differ, to
/// within `tolerance`: by Brent's method (R. P. Brent, *Algorithms for Minimization without
/// Derivatives*, 1973, chapter 4). `ends` are the two places with the function's values. Finds a
/// jump across zero as well.
///
/// # Errors
/// That of the function.
pub fn root<E>(
    mut function: impl FnMut(f64) -> Result<f64, E>,
    ends: [(f64, f64); 2],
    tolerance: f64,
) -> Result<f64, E> {
    // `b` is the best place so far, `a` the one before, and the zero is between `b` and `c`.
    let [mut a, mut b] = ends;
    let mut c = a;
    let (mut last, mut before_last) = (b.0 - a.0, b.0 - a.0);
    for _ in 0..STEPS {
        if (b.1 > 0.0) == (c.1 > 0.0) {
            c = a;
            last = b.0 - a.0;
            before_last = last;
        }
        if c.1.abs() < b.1.abs() {
            (a, b, c) = (b, c, b);
        }
        let half = 0.5 * (c.0 - b.0);
        let least = 0.5 * tolerance + 2.0 * f64::EPSILON * b.0.abs();
        if half.abs() <= least || b.1 == 0.0 {
            break;
        }
        let inner = (before_last.abs() >= least && a.1.abs() > b.1.abs())
            .then(|| interpolated(a, b, c))
            .filter(|step| {
                let towards = step * half > 0.0;
                let inside = 2.0 * step.abs() < 3.0 * half.abs() - least;
                towards && inside && 2.0 * step.abs() < before_last.abs()
            });
        (before_last, last) = match inner {
            Some(step) => (last, step),
            None => (half, half),
        };
        a = b;
        let step = if last.abs() > least { last } else { least.copysign(half) };
        let next = b.0 + step;
        b = (next, function(next)?);
    }
    Ok(b.0)
}

/// Distance of the zero from `b` by the inverse parabola through three places, by the secant where
/// two of them coincide.
fn interpolated(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> f64 {
    let s = b.1 / a.1;
    if a.0 == c.0 {
        return s * (c.0 - b.0) / (s - 1.0);
    }
    let (q, r) = (a.1 / c.1, b.1 / c.1);
    let numerator = s * (q * (q - r) * (c.0 - b.0) - (b.0 - a.0) * (r - 1.0));
    numerator / ((q - 1.0) * (r - 1.0) * (1.0 - s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    fn found(function: impl Fn(f64) -> f64, from: f64, to: f64) -> (f64, usize) {
        let mut count = 0;
        let counted = |x: f64| {
            count += 1;
            Ok::<f64, Infallible>(function(x))
        };
        let Ok(x) = root(counted, [(from, function(from)), (to, function(to))], 1e-12);
        (x, count)
    }

    #[test]
    fn smooth_zeros_take_few_steps() {
        let (x, count) = found(|x| x * x * x - 2.0 * x - 5.0, 2.0, 3.0);
        assert!((x - 2.094_551_481_542_326_6).abs() < 1e-12 && count < 12, "{x} {count}");
        let (x, count) = found(|x| x.cos() - x, 1.0, 0.0);
        assert!((x - 0.739_085_133_215_160_6).abs() < 1e-12 && count < 12, "{x} {count}");
    }

    #[test]
    fn steep_flat_and_broken_ones_are_found_as_well() {
        let (x, _) = found(|x| (50.0 * (x - 0.3)).atan().powi(3), 0.0, 1.0);
        assert!((x - 0.3).abs() < 1e-5, "{x}");
        let (x, count) = found(|x| if x < 0.7 { 1.0 - x } else { -1.0 }, 0.0, 1.0);
        assert!((x - 0.7).abs() < 1e-11 && count < 120, "{x} {count}");
        let (x, _) = found(|x| x - 0.5, 0.0, 0.5);
        assert_eq!(x, 0.5);
    }
}
