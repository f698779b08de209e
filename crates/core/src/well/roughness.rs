//! Roughness and micro-tortuosity: deviations of a wall that neither survey nor caliper shows.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use serde::Serialize;

use crate::random::Random;

/// Deviations of a wall from the smooth one, as statistics and a seed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Roughness {
    /// Root mean square departure of the hole's radius, m.
    pub radius_rms_m: f64,
    /// Root mean square distance of the hole's axis from the surveyed path, m.
    pub tortuosity_rms_m: f64,
    /// Shortest wavelength along the hole, m.
    pub shortest_m: f64,
    /// Longest wavelength, m.
    pub longest_m: f64,
    /// Which of the walls with these statistics.
    pub seed: u64,
}

/// Number of waves that a wall is made of.
const WAVES: usize = 32;

/// Each wavelength is in the middle half of its part of the band: no two waves beat for kilometres.
const JITTER: [f64; 2] = [0.25, 0.5];

/// The rough wall defined by a [`Roughness`], a function of measured depth alone: 32 sinusoids of
/// equal amplitude, their wavelengths evenly spread over the logarithm of the band and jittered
/// within, their phases random.
///
/// The generator is SplitMix64; wave by wave it gives the jitter, then the phases of the radius and
/// of the axis' offset to north, east and down. Numbers agree on every machine to 1e-9 m: only the
/// rounding of the machine's sine differs.
#[derive(Debug, Clone, PartialEq)]
pub struct Relief {
    waves: [Wave; WAVES],
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Wave {
    /// `2π` over the wavelength, 1/m.
    number_per_m: f64,
    /// Amplitude times cosine and sine of the phase, m: of the radius and of the three offsets.
    parts: [[f64; 2]; 4],
}

/// The relief at one depth: departures from the smooth wall, and their derivatives along the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReliefPoint {
    /// Of the radius: m, and per metre.
    pub radius: [f64; 2],
    /// Of the axis, before its part across the path is taken: m, per metre and per metre squared.
    pub offset: [Vector3<f64>; 3],
}

impl Relief {
    /// The wall.
    pub fn new(roughness: &Roughness) -> Self {
        let mut random = Random::new(roughness.seed);
        let band = libm::log(roughness.longest_m / roughness.shortest_m);
        let count = WAVES as f64;
        // A sinusoid's mean square is half its amplitude's square. Of three offsets of the same
        // rms, two are across the hole, and add up to the distance from the path.
        let radius = roughness.radius_rms_m * (2.0 / count).sqrt();
        let offset = roughness.tortuosity_rms_m / count.sqrt();
        let waves = std::array::from_fn(|index| {
            let place = index as f64 + JITTER[0] + JITTER[1] * random.unit();
            let wavelength_m = roughness.shortest_m * libm::exp(band * place / count);
            let parts = [radius, offset, offset, offset].map(|amplitude| {
                let phase = TAU * random.unit();
                [amplitude * libm::cos(phase), amplitude * libm::sin(phase)]
            });
            Wave { number_per_m: TAU / wavelength_m, parts }
        });
        Self { waves }
    }

    /// The relief at a measured depth, m.
    pub fn at(&self, md_m: f64) -> ReliefPoint {
        let mut value = [0.0; 4];
        let mut first = [0.0; 4];
        let mut second = [0.0; 4];
        for wave in &self.waves {
            let k = wave.number_per_m;
            let (sin, cos) = libm::sincos(k * md_m);
            for (signal, [c, s]) in wave.parts.iter().enumerate() {
                let height = sin * c + cos * s;
                value[signal] += height;
                first[signal] += k * (cos * c - sin * s);
                second[signal] -= k * k * height;
            }
        }
        let vector = |terms: [f64; 4]| Vector3::new(terms[1], terms[2], terms[3]);
        ReliefPoint {
            radius: [value[0], first[0]],
            offset: [vector(value), vector(first), vector(second)],
        }
    }
}

impl ReliefPoint {
    /// The relief where its size changes along the hole by `factor`, given with its first two
    /// derivatives.
    pub fn scaled(&self, factor: [f64; 3]) -> Self {
        let [f, f1, f2] = factor;
        let [radius, slope] = self.radius;
        let [offset, tilt, bend] = self.offset;
        Self {
            radius: [f * radius, f * slope + f1 * radius],
            offset: [
                offset * f,
                tilt * f + offset * f1,
                bend * f + tilt * (2.0 * f1) + offset * f2,
            ],
        }
    }
}
