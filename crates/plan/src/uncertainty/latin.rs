//! Points that fill the ranges of all inputs evenly.

use wholestring::random::Random;

use super::Distribution;

/// Returns a Latin hypercube (McKay, Beckman and Conover 1979): `count` points, each with a value
/// of every input, such that each of `count` equally likely parts of every input contains one of
/// them. The same seed gives the same points on every machine.
pub fn latin_hypercube(inputs: &[Distribution], count: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut random = Random::new(seed);
    let mut points = vec![Vec::with_capacity(inputs.len()); count];
    for input in inputs {
        let mut parts: Vec<usize> = (0..count).collect();
        // Fisher and Yates.
        for last in (1..count).rev() {
            let other = (random.unit() * (last + 1) as f64) as usize;
            parts.swap(last, other.min(last));
        }
        for (point, part) in points.iter_mut().zip(parts) {
            // Neither 0 nor 1, at which a normal distribution has no value.
            let within = (random.unit() + 0.5 * f64::EPSILON).min(1.0 - f64::EPSILON);
            point.push(input.quantile((part as f64 + within) / count as f64));
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    const INPUTS: [Distribution; 2] = [
        Distribution::Uniform { from: 2.0, to: 4.0 },
        Distribution::Normal { mean: 0.0, std: 1.0 },
    ];

    #[test]
    fn every_part_holds_one_point() {
        let count = 50;
        let points = latin_hypercube(&INPUTS, count, 7);
        for (place, input) in INPUTS.iter().enumerate() {
            let mut values: Vec<f64> = points.iter().map(|point| point[place]).collect();
            values.sort_by(f64::total_cmp);
            for (part, value) in values.iter().enumerate() {
                let bound = |part: usize| match part {
                    0 => f64::NEG_INFINITY,
                    part if part == count => f64::INFINITY,
                    part => input.quantile(part as f64 / count as f64),
                };
                assert!((bound(part)..bound(part + 1)).contains(value), "{part} {value}");
            }
        }
        assert_eq!(latin_hypercube(&INPUTS, count, 7), points);
        assert_ne!(latin_hypercube(&INPUTS, count, 8), points);
    }

    /// The mean of a sum of inputs varies from seed to seed far less than that of random points.
    #[test]
    fn means_are_nearly_exact() {
        let points = latin_hypercube(&INPUTS, 200, 1);
        let mean = points.iter().map(|point| point[0] + point[1]).sum::<f64>() / 200.0;
        // With random points 0.08.
        assert!((mean - 3.0).abs() < 2e-3, "{mean}");
    }
}
