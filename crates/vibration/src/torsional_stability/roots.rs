//! Roots of a characteristic function: how many are unstable, by the argument principle, and which
//! grows most, by secants.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Complex;

use super::characteristic::{SteadyRotation, Value};
use crate::complex;

/// Samples of the imaginary axis from one root of the string to the next.
const PER_ROOT: f64 = 6.0;

/// Largest turn of the function between two samples, rad, and largest change of the logarithm of
/// its magnitude.
const MOST_TURN: f64 = 0.8;
const MOST_CHANGE: f64 = 1.5;

/// Halvings of an interval after which it is left as it is.
const HALVINGS: usize = 24;

/// Roots that are followed to their end at a point of the map.
const FOLLOWED: usize = 8;

/// Position of the second point of a secant, as a fraction of the distance to the estimated root.
const NEAR: f64 = 0.05;

/// Rounds in which growing roots are looked for that were not found at first.
const ROUNDS: usize = 6;

/// Steps of a secant.
const STEPS: usize = 40;

/// Band of the search for roots: between two magnitudes, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// Slower motions are left to the hoist.
    pub lowest_rad_per_s: f64,
    /// Faster motions are not searched.
    pub highest_rad_per_s: f64,
}

/// A root `σ + iω`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// `σ`: how fast the motion grows, 1/s; negative of one that dies away.
    pub growth_per_s: f64,
    /// `ω/2π`, Hz.
    pub frequency_Hz: f64,
}

/// Result of the linear vibration about steady rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stability {
    /// Roots in the band that grow, a pair counted twice.
    pub unstable_roots: usize,
    /// The root that grows most of those that were followed; none where none was found.
    pub worst: Option<Root>,
    /// Whether as many growing roots were followed as there are.
    pub complete: bool,
}

impl Stability {
    /// Whether every small motion in the band dies away.
    pub fn is_stable(&self) -> bool {
        self.unstable_roots == 0
    }
}

/// A point of the function.
#[derive(Clone, Copy)]
struct Sample {
    place: f64,
    s: Complex<f64>,
    value: Value,
}

impl SteadyRotation {
    /// Stability of small vibrations whose frequency and growth are in a band.
    pub fn stability(&self, band: Band) -> Stability {
        let Band { lowest_rad_per_s: low, highest_rad_per_s: high } = band;
        let travel_s = self.travel_s();
        let samples = |length: f64| ((length * travel_s * PER_ROOT / PI) as usize).max(24);
        let axis = self.trace(|w| Complex::new(0.0, w), [low, high], samples(high - low), true);
        // Where no roots are near, the function's phase changes by the travel time.
        let outer = self.trace(
            |angle| complex::polar(high, angle),
            [0.0, FRAC_PI_2],
            samples(high) / 2,
            false,
        );
        let inner = self.trace(|angle| complex::polar(low, angle), [0.0, FRAC_PI_2], 24, false);
        let turns = (turn(&outer) - turn(&inner) - turn(&axis)) / PI;
        let unstable_roots = turns.round().max(0.0) as usize;
        let mut found = self.follow(starts(&axis), band, &[]);
        // Others, with those that are known divided out.
        for round in 0..ROUNDS {
            if count(&found, band) >= unstable_roots {
                break;
            }
            let more = self.follow(everywhere(band, travel_s, round), band, &found);
            found.extend(more);
            distinct(&mut found);
        }
        let growing = count(&found, band);
        let worst = found.iter().max_by(|a, b| a.re.total_cmp(&b.re));
        Stability {
            unstable_roots,
            worst: worst
                .map(|s| Root { growth_per_s: s.re, frequency_Hz: s.im / std::f64::consts::TAU }),
            complete: growing == unstable_roots,
        }
    }

    /// Samples along a curve, so close that the function turns little from one to the next.
    fn trace(
        &self,
        curve: impl Fn(f64) -> Complex<f64>,
        [from, to]: [f64; 2],
        intervals: usize,
        by_size: bool,
    ) -> Vec<Sample> {
        let place = |i: usize| from + (to - from) * i as f64 / intervals as f64;
        let evaluate = |places: Vec<f64>| -> Vec<Sample> {
            let s: Vec<Complex<f64>> = places.iter().map(|t| curve(*t)).collect();
            let values = self.values(&s);
            let each = places.into_iter().zip(s).zip(values);
            each.map(|((place, s), value)| Sample { place, s, value }).collect()
        };
        let mut samples = evaluate((0..=intervals).map(place).collect());
        for _ in 0..HALVINGS {
            let coarse = |pair: &[Sample]| {
                let change = pair[1].value.ln_norm() - pair[0].value.ln_norm();
                angle(pair).abs() > MOST_TURN || by_size && change.abs() > MOST_CHANGE
            };
            let middle = |pair: &[Sample]| 0.5 * (pair[0].place + pair[1].place);
            let between: Vec<f64> =
                samples.windows(2).filter(|pair| coarse(pair)).map(middle).collect();
            if between.is_empty() {
                break;
            }
            samples.extend(evaluate(between));
            samples.sort_by(|a, b| a.place.total_cmp(&b.place));
        }
        samples
    }

    /// The function without the roots that are known.
    fn divided(&self, frequencies: &[Complex<f64>], known: &[Complex<f64>]) -> Vec<Value> {
        let mut values = self.values(frequencies);
        for (value, s) in values.iter_mut().zip(frequencies) {
            for root in known {
                let mut off = *s - root;
                if root.im > 0.0 {
                    off *= *s - root.conj();
                }
                value.mantissa /= off / complex::norm(off);
                value.ln_scale -= libm::log(complex::norm(off));
            }
        }
        values
    }

    /// Follows secants to roots in the band that are not known, each once.
    fn follow(
        &self,
        starts: Vec<[Complex<f64>; 2]>,
        band: Band,
        known: &[Complex<f64>],
    ) -> Vec<Complex<f64>> {
        let mut found = Vec::new();
        let ends: Vec<Complex<f64>> = starts.iter().flatten().copied().collect();
        let values = self.divided(&ends, known);
        let mut going: Vec<[(Complex<f64>, Value); 2]> = ends
            .chunks_exact(2)
            .zip(values.chunks_exact(2))
            .map(|(s, f)| [(s[0], f[0]), (s[1], f[1])])
            .collect();
        for _ in 0..STEPS {
            let mut next = Vec::new();
            let mut pending = Vec::new();
            for [(s0, f0), (s1, f1)] in going {
                // s₁ − f₁ (s₁ − s₀)/(f₁ − f₀).
                let step = (s1 - s0) / (-f0.over(&f1) + 1.0);
                let s2 = s1 - step;
                // Not a number is not near.
                let near = complex::norm(s2) <= 2.0 * band.highest_rad_per_s;
                if !near {
                    continue;
                }
                // Next to a huge value a first step is small at any point.
                let before = complex::norm(s1 - s0);
                let size = 1.0 + complex::norm(s1);
                if complex::norm(step) < 1e-9 * size && before < 1e-4 * size {
                    // Of a pair, the one above.
                    found.push(Complex::new(s2.re, s2.im.abs()));
                } else {
                    next.push(s2);
                    pending.push((s1, f1));
                }
            }
            if next.is_empty() {
                break;
            }
            let values = self.divided(&next, known);
            let ends = next.into_iter().zip(values);
            going = pending.into_iter().zip(ends).map(|(before, now)| [before, now]).collect();
        }
        found.retain(|s| {
            (band.lowest_rad_per_s..=band.highest_rad_per_s).contains(&complex::norm(*s))
        });
        distinct(&mut found);
        found
    }
}

/// Phase change of the function between two samples, rad.
fn angle(pair: &[Sample]) -> f64 {
    complex::argument(pair[1].value.mantissa / pair[0].value.mantissa)
}

/// Phase change along a curve, rad.
fn turn(samples: &[Sample]) -> f64 {
    samples.windows(2).map(angle).sum()
}

/// Leaves each root once.
fn distinct(roots: &mut Vec<Complex<f64>>) {
    roots.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
    roots.dedup_by(|a, b| complex::norm(*a - *b) < 1e-6 * (1.0 + complex::norm(*b)));
}

/// Number of these that grow, pairs counted twice.
fn count(roots: &[Complex<f64>], band: Band) -> usize {
    let pair = |s: &&Complex<f64>| s.im > 1e-6 * band.lowest_rad_per_s;
    let growing = roots.iter().filter(|s| s.re > 0.0);
    growing.clone().count() + growing.filter(pair).count()
}

/// Estimates of roots near the axis: a sample, and the zero predicted by the function's slope
/// there. They include those that seem to grow, and a limited number of others.
fn starts(axis: &[Sample]) -> Vec<[Complex<f64>; 2]> {
    let steps: Vec<Complex<f64>> = axis
        .windows(3)
        .map(|axis| {
            let slope = (axis[2].value.over(&axis[1].value) - axis[0].value.over(&axis[1].value))
                / (axis[2].s - axis[0].s);
            -slope.inv()
        })
        .collect();
    let mut starts: Vec<[Complex<f64>; 2]> = Vec::new();
    for (at, window) in steps.windows(3).enumerate() {
        if complex::norm(window[1]) <= complex::norm(window[0])
            && complex::norm(window[1]) <= complex::norm(window[2])
        {
            let s = axis[at + 2].s;
            // So near that the first secant is a tangent.
            starts.push([s, s + window[1] * NEAR]);
        }
    }
    starts.sort_by(|a, b| b[1].re.total_cmp(&a[1].re));
    let growing = starts.iter().filter(|start| start[1].re > 0.0).count();
    starts.truncate(growing + FOLLOWED);
    starts
}

/// Starts all over the quarter in which roots grow, elsewhere in each round.
fn everywhere(band: Band, travel_s: f64, round: usize) -> Vec<[Complex<f64>; 2]> {
    let between = PI / travel_s;
    let rows = (band.highest_rad_per_s / between) as usize + 1;
    let shift = (0.37 + 0.618 * round as f64).fract();
    let columns = [0.03, 0.3, 1.0, 3.0].map(|re| re * (0.7 + shift));
    (0..rows)
        .flat_map(|row| columns.into_iter().map(move |re| (row, re)))
        .map(|(row, re)| {
            let s = Complex::new(re * between, (row as f64 + shift) * between);
            [s, s * Complex::new(1.001, 0.001)]
        })
        .collect()
}
