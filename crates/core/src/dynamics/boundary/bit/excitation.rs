//! Excitation of a bit that drills at a given rate: the pattern that it leaves on bottom, and
//! noise.

use serde::{Deserialize, Serialize};

use crate::{
    dynamics::assemble::{SetupError, check_numbers},
    random::Random,
};

/// Excitation of the bit.
///
/// The rock front under the bit is deeper by `A sin(m φ) + r g(x)`, with `φ` the angle through
/// which the bit has turned, `m` the lobes, `g` seeded noise of mean zero and variance one. The
/// torque is multiplied by `1 + q g'(x)`, but never changes its sign.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Excitation {
    /// Lobes `m` of the bottom pattern per revolution: three of a tricone bit.
    pub lobes: u32,
    /// Amplitude `A` of the lobes, m: half the height from trough to crest.
    pub amplitude_m: f64,
    /// Roughness `r` of the bottom, m rms.
    pub roughness_m: f64,
    /// Fluctuation `q` of the torque, rms, as a fraction of the torque.
    pub torque_fluctuation: f64,
    /// Variable and bandwidth of the noise.
    pub band: Band,
}

/// Variable of the noise, and the value at which its power density has fallen to half.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Band {
    /// By the bit's angle: waves per revolution. A stationary bit is not excited.
    PerRevolution(f64),
    /// By time, 1/s, whatever the bit does.
    PerSecond(f64),
}

/// Spacing of the noise's knots, in wavelengths at half power: `sinc⁸(0.2275) = 1/2`.
const KNOT_SPACING: f64 = 0.227_53;

/// State of the excitation.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Shaker {
    excitation: Excitation,
    bottom: Noise,
    torque: Noise,
    angle_rad: f64,
    time_s: f64,
}

/// Amplitudes of the noise.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spread {
    /// Roughness of the front, m rms.
    pub(super) roughness_m: f64,
    /// Fluctuation of the torque, rms, as a fraction of it.
    pub(super) torque_fluctuation: f64,
}

impl Excitation {
    /// Refuses numbers that no run can use.
    pub(super) fn check(&self) -> Result<(), SetupError> {
        let (Band::PerRevolution(band) | Band::PerSecond(band)) = self.band;
        check_numbers(
            &[("bit.excitation.band", band)],
            &[
                ("bit.excitation.amplitude_m", self.amplitude_m),
                ("bit.excitation.roughness_m", self.roughness_m),
                ("bit.excitation.torque_fluctuation", self.torque_fluctuation),
            ],
        )
    }

    pub(super) fn spread(&self) -> Spread {
        Spread { roughness_m: self.roughness_m, torque_fluctuation: self.torque_fluctuation }
    }
}

/// The excitation at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shake {
    /// Additional depth of the rock front, m.
    pub front_m: f64,
    /// By which fraction the torque is larger.
    pub torque: f64,
}

impl Shake {
    /// Both.
    pub(super) fn plus(self, other: Self) -> Self {
        Self { front_m: self.front_m + other.front_m, torque: self.torque + other.torque }
    }
}

impl Shaker {
    pub(super) fn new(excitation: Excitation, seed: u64) -> Self {
        Self {
            excitation,
            bottom: Noise::new(seed, 1),
            torque: Noise::new(seed, 2),
            angle_rad: 0.0,
            time_s: 0.0,
        }
    }

    /// The excitation after a turn and a time more.
    pub(super) fn next(&self, turn_rad: f64, dt: f64) -> Shake {
        self.next_of(self.excitation.spread(), turn_rad, dt)
    }

    /// The same with another spread.
    pub(super) fn next_of(&self, spread: Spread, turn_rad: f64, dt: f64) -> Shake {
        let e = &self.excitation;
        let angle = self.angle_rad + turn_rad;
        let knots = match e.band {
            Band::PerRevolution(waves) => waves * angle / std::f64::consts::TAU,
            Band::PerSecond(frequency) => frequency * (self.time_s + dt),
        } / KNOT_SPACING;
        let noise = |rms: f64, noise: &Noise| {
            if rms > 0.0 { rms * noise.at(knots) } else { 0.0 }
        };
        Shake {
            front_m: e.amplitude_m * libm::sin(f64::from(e.lobes) * angle)
                + noise(spread.roughness_m, &self.bottom),
            torque: noise(spread.torque_fluctuation, &self.torque),
        }
    }

    /// Advances by an angle and a time.
    pub(super) fn advance(&mut self, turn_rad: f64, dt: f64) {
        self.angle_rad += turn_rad;
        self.time_s += dt;
    }
}

/// Smooth noise along a line: independent random numbers at whole places, blended by the cubic
/// B-spline.
///
/// It is a function of the place alone, so that neither step nor history nor direction of motion
/// can change it. Its power density falls as `sinc⁸(f)`, `f` in waves per knot.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Noise {
    key: u64,
}

impl Noise {
    fn new(seed: u64, stream: u64) -> Self {
        Self { key: scramble(seed ^ scramble(stream)) }
    }

    fn at(self, place: f64) -> f64 {
        let knot = place.floor();
        let x = place - knot;
        let knot = knot as i64;
        let y = 1.0 - x;
        // The four cubic B-splines that are not zero here.
        let blend = [
            y * y * y / 6.0,
            2.0 / 3.0 - x * x * (1.0 - 0.5 * x),
            2.0 / 3.0 - y * y * (1.0 - 0.5 * y),
            x * x * x / 6.0,
        ];
        let sum: f64 = (-1..3).zip(blend).map(|(k, b)| b * self.knot(knot.wrapping_add(k))).sum();
        // The blend leaves 151/315 of the variance on average.
        sum * (315.0f64 / 151.0).sqrt()
    }

    /// The sum of four even random numbers, of mean zero and variance one: near to normal, never
    /// beyond 3.5, and the same on every machine.
    fn knot(self, knot: i64) -> f64 {
        let bits = scramble(self.key ^ knot.cast_unsigned());
        let sum: u64 = (0..4).map(|i| (bits >> (16 * i)) & 0xffff).sum();
        (sum as f64 - 2.0 * 65_535.0) * (3f64.sqrt() / 65_536.0)
    }
}

/// Random bits that belong to a number.
fn scramble(number: u64) -> u64 {
    Random::new(number).bits()
}

#[cfg(test)]
mod tests;
