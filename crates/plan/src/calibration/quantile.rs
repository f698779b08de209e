//! Quantiles of the normal distribution and of Student's.

use std::f64::consts::PI;

/// Normal probability below a number (Abramowitz and Stegun 26.2.11, a series that converges
/// everywhere).
pub fn normal_below(z: f64) -> f64 {
    let (mut term, mut sum) = (z, z);
    let mut odd = 1.0;
    while term.abs() > 1e-17 * sum.abs() && odd < 400.0 {
        odd += 2.0;
        term *= z * z / odd;
        sum += term;
    }
    0.5 + sum * libm::exp(-0.5 * z * z) / (2.0 * PI).sqrt()
}

/// Returns the number within which, to either side of zero, a normal variable is with a
/// probability.
pub fn normal_within(probability: f64) -> f64 {
    let below = 0.5 * (1.0 + probability.clamp(0.0, 0.999_999));
    let mut z = 1.0_f64;
    for _ in 0..50 {
        let density = libm::exp(-0.5 * z * z) / (2.0 * PI).sqrt();
        // The step is limited to a length for which the density is accurate.
        z -= ((normal_below(z) - below) / density).clamp(-0.5, 0.5);
    }
    z
}

/// Returns the same for Student's distribution with this number of degrees of freedom (the
/// expansion of Abramowitz and Stegun 26.7.5, to 1 % from four degrees on).
pub fn student_within(probability: f64, degrees: f64) -> f64 {
    let x = normal_within(probability);
    let terms = [
        (x.powi(3) + x) / 4.0,
        (5.0 * x.powi(5) + 16.0 * x.powi(3) + 3.0 * x) / 96.0,
        (3.0 * x.powi(7) + 19.0 * x.powi(5) + 17.0 * x.powi(3) - 15.0 * x) / 384.0,
        (79.0 * x.powi(9) + 776.0 * x.powi(7) + 1482.0 * x.powi(5)
            - 1920.0 * x.powi(3)
            - 945.0 * x)
            / 92_160.0,
    ];
    let powers = (1..).map(|power| degrees.powi(power));
    x + terms.iter().zip(powers).map(|(term, power)| term / power).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tables 26.1, 26.5 and 26.10 of Abramowitz and Stegun.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (probability, z) in [(0.9, 1.644_853_6), (0.95, 1.959_964_0), (0.99, 2.575_829_3)] {
            assert!((normal_within(probability) - z).abs() < 1e-7);
        }
        for (degrees, t) in [(4.0, 2.776), (10.0, 2.228), (20.0, 2.086), (60.0, 2.000)] {
            assert!((student_within(0.95, degrees) / t - 1.0).abs() < 2e-3, "{degrees}");
        }
    }
}
