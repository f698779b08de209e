//! A rock front that the bit cuts away, for the laws that know no more of the bottom than its
//! depth.

use serde::{Deserialize, Serialize};

use super::{
    excitation::{Excitation, Shake, Shaker},
    law::rules::{CutStart, CutState},
    motor::{Drive, Turned},
    rate_segment::RateSegment,
    step::{Approach, BitRockStep, RockReaction},
    table::TableUse,
};
use crate::{
    damage::{Damaged, ensure},
    dynamics::{
        assemble::{SetupError, check_numbers},
        boundary::extension::AnotherExtension,
    },
};

/// Relative tolerance of the weight under a user-defined law, and the maximum number of its
/// evaluations in a step.
const ROOT_TOLERANCE: f64 = 1e-12;
const MAX_ITERATIONS: usize = 100;

/// The rock front that the bit cuts away.
///
/// The rock front is at the depth that the bit has cut. A bit pressed against it with a force
/// advances it at the law's rate for that force and speed. The rate is piecewise linear in the
/// force, so the force at the step's end is found exactly. The bit leaves the rock freely. Its
/// torque opposes the rotation and holds the bit when nothing turns it any more. An excitation
/// raises and lowers the front under the bit.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct FrontCut<L> {
    law: L,
    stiffness_N_per_m: f64,
    front_m: f64,
    /// Weight at the end of the step before, N.
    weight_N: f64,
    shaker: Option<Shaker>,
}

/// A law for the rate at which the front advances under a weight, at a speed.
pub(super) trait FrontRule {
    /// The law with its numbers.
    type Law;

    /// Whether it is one of this law.
    fn is_of(&self, law: &Self::Law) -> bool;

    /// Gives a law of the caller's own that has been read back its own.
    fn attach(&mut self, _law: &Self::Law) -> Result<(), AnotherExtension> {
        Ok(())
    }

    /// The weight at a step's end, N, and the front's advance, m, of a bit that turns at a speed.
    fn press(&self, press: &Press, turning_rad_per_s: f64) -> (f64, f64);

    /// Torque, N·m, and depth of cut, m, under a weight at a speed, in each step once.
    fn cut(&mut self, weight_N: f64, turning_rad_per_s: f64) -> (f64, f64);

    /// Returns the excitation after a further turn and time; `weight_N` is that of the step before.
    fn shake(
        &self,
        shaker: Option<&Shaker>,
        _weight_N: f64,
        _turning_rad_per_s: f64,
        turn_rad: f64,
        dt: f64,
    ) -> Shake {
        shaker.map_or_else(Shake::default, |shaker| shaker.next(turn_rad, dt))
    }

    /// Effect of a torque on the rotation. Rock stops a bit but never turns it back.
    fn turn(&self, at: &Approach, drive: &mut Drive, required_N_m: f64) -> Turned {
        drive.turn(at.spin_rad_per_s, at.turning_mobility, required_N_m, 0.0)
    }

    /// Updates the law's state after a step.
    fn advance(&mut self, _step: &BitRockStep) {}

    /// Count and extent of the bit's excursions outside its table.
    fn table_use(&self) -> Option<TableUse> {
        None
    }

    /// Counts [`Self::table_use`] anew.
    fn restart(&mut self) {}
}

/// Refuses numbers of a front that no run can use.
pub(super) fn check_front(
    rock_stiffness_N_per_m: f64,
    excitation: Option<&Excitation>,
) -> Result<(), SetupError> {
    check_numbers(&[("bit.rock_stiffness_N_per_m", rock_stiffness_N_per_m)], &[])?;
    excitation.map_or(Ok(()), Excitation::check)
}

/// A bit on its rock in a step that the rock is to end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Press {
    /// Penetration of the bit beyond the front without the rock's force, m.
    over_m: f64,
    stiffness_N_per_m: f64,
    /// Velocity per axial force, s/kg.
    mobility_s_per_kg: f64,
    dt: f64,
}

impl Press {
    /// The weight at which the rock is compressed by as much as bit and front leave at the step's
    /// end, and the front's advance.
    pub(super) fn on(&self, segments: impl IntoIterator<Item = RateSegment>) -> (f64, f64) {
        let (k, dt) = (self.stiffness_N_per_m, self.dt);
        let mut found = (0.0, 0.0);
        for s in segments {
            // W = k (over − dt · mobility · W − dt v(W)), on a straight stretch of v(W).
            let yielding = 1.0 + k * dt * (self.mobility_s_per_kg + s.slope_m_per_s_per_N);
            // Where the rate falls so steeply with the weight, more weight compresses the rock
            // less.
            if yielding <= 0.0 {
                continue;
            }
            let offset = s.from_m_per_s - s.slope_m_per_s_per_N * s.from_N;
            let weight = ((k * self.over_m - k * dt * offset) / yielding).max(s.from_N);
            let advance = dt * s.slope_m_per_s_per_N * (weight - s.from_N) + dt * s.from_m_per_s;
            found = (weight, advance);
            if weight <= s.to_N {
                break;
            }
        }
        found
    }

    /// The same where the rate at a weight is whatever it is, as long as it does not fall: the
    /// weight `W` with `W = k (over − dt (mobility W + rate(W)))`.
    pub(super) fn on_rate(&self, rate_m_per_s: impl Fn(f64) -> f64) -> (f64, f64) {
        if self.over_m.is_nan() || self.over_m <= 0.0 {
            return (0.0, 0.0);
        }
        let (k, dt) = (self.stiffness_N_per_m, self.dt);
        let yielding = libm::fma(k * dt, self.mobility_s_per_kg, 1.0);
        let advance = |weight: f64| dt * rate_m_per_s(weight).max(0.0);
        let excess = |weight: f64| libm::fma(yielding, weight, k * (advance(weight) - self.over_m));
        let (mut low, mut high) = (0.0, k * self.over_m / yielding);
        let (mut below, mut above) = (excess(low), excess(high));
        if below >= 0.0 {
            return (0.0, advance(0.0).min(self.over_m));
        }
        // Illinois: regula falsi that halves the value at an end which stays. A straight line takes
        // one step.
        let mut weight = high;
        let mut stayed = 0;
        for _ in 0..MAX_ITERATIONS {
            if above <= 0.0 || high - low <= ROOT_TOLERANCE * high {
                break;
            }
            weight = (low * above - high * below) / (above - below);
            let value = excess(weight);
            if value.abs() <= ROOT_TOLERANCE * k * self.over_m {
                break;
            }
            if value < 0.0 {
                (low, below) = (weight, value);
                if stayed == 1 {
                    above *= 0.5;
                }
                stayed = 1;
            } else {
                (high, above) = (weight, value);
                if stayed == -1 {
                    below *= 0.5;
                }
                stayed = -1;
            }
        }
        (weight, advance(weight))
    }
}

impl<L: FrontRule> FrontCut<L> {
    /// The front under a bit that drills steadily.
    pub(super) fn new(
        law: L,
        stiffness_N_per_m: f64,
        excitation: Option<Excitation>,
        start: &CutStart<'_>,
    ) -> Self {
        let weight_N = start.operation.weight_on_bit_now_N();
        let turning = start.operation.rotation_rad_per_s() + start.drive.speed_rad_per_s();
        let mut cut = Self {
            law,
            stiffness_N_per_m,
            front_m: start.depth_m - weight_N / stiffness_N_per_m,
            weight_N,
            shaker: excitation.map(|excitation| Shaker::new(excitation, start.seed)),
        };
        // The operation begins with its weight, whatever the phase of the excitation.
        cut.front_m -= cut.shake(turning, 0.0, 0.0).front_m;
        cut
    }

    fn shake(&self, turning: f64, turn_rad: f64, dt: f64) -> Shake {
        self.law.shake(self.shaker.as_ref(), self.weight_N, turning, turn_rad, dt)
    }
}

impl<L: FrontRule> CutState for FrontCut<L> {
    type Law = L::Law;

    fn check(&self, law: &L::Law) -> Result<(), Damaged> {
        ensure(self.law.is_of(law), "the law of the bit")
    }

    fn attach(&mut self, law: &L::Law) -> Result<(), AnotherExtension> {
        self.law.attach(law)
    }

    fn meet(&mut self, at: &Approach, drive: &mut Drive) -> Option<RockReaction> {
        // The spin that the step gave without the rock is not the bit's: its torque is to come.
        let turning = at.spin_before_rad_per_s + drive.speed_rad_per_s();
        let shake = self.shake(turning, turning * at.dt, at.dt).plus(at.shake);
        let press = Press {
            over_m: at.depth_m - (self.front_m + shake.front_m),
            stiffness_N_per_m: self.stiffness_N_per_m,
            mobility_s_per_kg: at.axial_mobility_s_per_kg,
            dt: at.dt,
        };
        let (weight, advance) = self.law.press(&press, turning);
        self.front_m += advance;
        self.weight_N = weight;
        let (steady, depth_of_cut_m) = self.law.cut(weight, turning);
        // A fluctuation never makes the rock turn the bit.
        let required_N_m = steady * (1.0 + shake.torque).max(0.0);
        let turned = self.law.turn(at, drive, required_N_m);
        if let Some(shaker) = &mut self.shaker {
            shaker.advance(turned.bit_rad_per_s * at.dt, at.dt);
        }
        self.law.advance(&BitRockStep {
            dt_s: at.dt,
            weight_on_bit_N: weight,
            torque_N_m: turned.torque_N_m,
            bit_speed_rad_per_s: turned.bit_rad_per_s,
            advance_m: advance,
        });
        Some(RockReaction {
            weight_N: weight,
            torque_N_m: turned.torque_N_m,
            spin_rad_per_s: turned.string_rad_per_s,
            depth_of_cut_m,
            rate_m_per_s: advance / at.dt,
        })
    }

    fn table_use(&self) -> Option<TableUse> {
        self.law.table_use()
    }

    fn restart(&mut self) {
        self.law.restart();
    }
}
