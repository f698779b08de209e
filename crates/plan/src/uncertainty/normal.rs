//! The normal distribution.

use std::f64::consts::{PI, SQRT_2};

/// Part of a normal distribution below `z` standard deviations.
pub(super) fn below(z: f64) -> f64 {
    0.5 * libm::erfc(-z / SQRT_2)
}

/// Returns the number of standard deviations below which a part of a normal distribution lies, to
/// double precision; `part` is between 0 and 1, both excluded.
pub(super) fn quantile(part: f64) -> f64 {
    if part > 0.5 {
        return -quantile(1.0 - part);
    }
    // Abramowitz and Stegun (1964), 26.2.23: to 4.5e-4.
    let t = (-2.0 * libm::log(part)).sqrt();
    let above = 2.515_517 + t * (0.802_853 + t * 0.010_328);
    let under = 1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308));
    let mut z = above / under - t;
    // Halley's method cubes the error.
    for _ in 0..3 {
        let step = (below(z) - part) / density(z);
        z -= step / (1.0 + 0.5 * z * step);
    }
    z
}

/// Returns the density at `z` standard deviations.
pub(super) fn density(z: f64) -> f64 {
    libm::exp(-0.5 * z * z) / (2.0 * PI).sqrt()
}

/// Part of a normal distribution between two numbers of standard deviations, exact in either tail.
pub(super) fn between(a: f64, b: f64) -> f64 {
    // The difference of two parts near one would lose precision.
    if a > 0.0 { below(-a) - below(-b) } else { below(b) - below(a) }
}

/// Returns the number of standard deviations below which a part of the range between two of them
/// lies.
pub(super) fn quantile_between(a: f64, b: f64, part: f64) -> f64 {
    if a > 0.0 {
        return -quantile_between(-b, -a, 1.0 - part);
    }
    quantile(below(a) + part * (below(b) - below(a)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_tables() {
        for (part, expected) in [
            (0.5, 0.0),
            (0.975, 1.959_963_984_540_054),
            (0.05, -1.644_853_626_951_472_7),
            (1e-9, -5.997_807_015_007_687),
        ] {
            assert!((quantile(part) - expected).abs() < 1e-12, "{part}");
            assert!((below(quantile(part)) / part - 1.0).abs() < 1e-12, "{part}");
        }
    }
}
