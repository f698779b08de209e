//! A rock front that the bit cuts away, for the laws that know no more of the bottom than its
//! depth.

use super::{
    CustomLaw, DetournayDefournyLaw, TableLaw,
    custom::{BitRockStep, CustomCut},
    excitation::{Shake, Shaker},
    motor::{Drive, Turned},
    rate::Rate,
    rate_segment::RateSegment,
    settings::BitLaw,
    step::{Approach, RockReaction},
    table::{Counter, TableUse},
};
use crate::{
    damage::{Damaged, ensure},
    dynamics::boundary::extension::AnotherExtension,
};
use serde::{Deserialize, Serialize};

/// Relative tolerance of the weight under a law of the caller's own, and the most times that it is
/// asked for it in a step.
const ROOT_TOLERANCE: f64 = 1e-12;
const MAX_ITERATIONS: usize = 100;

/// The rock front that the bit cuts away.
///
/// The rock front lies where the bit has cut to. Pressed against it with a force, the bit advances
/// it at the rate that the law says of force and speed, which straight stretches make: so the force
/// at the step's end is found exactly. The bit leaves the rock freely. Its torque is against the
/// rotation and holds the bit when nothing turns it any more. An excitation raises and lowers the
/// front under the bit.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct FrontCut {
    law: FrontLaw,
    stiffness_N_per_m: f64,
    front_m: f64,
    /// Weight at the end of the step before, N.
    weight_N: f64,
    shaker: Option<Shaker>,
}

/// The laws of the rate.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) enum FrontLaw {
    Rate(Rate),
    DetournayDefourny(DetournayDefournyLaw),
    Table(TableLaw, Counter),
    Custom(CustomCut),
}

/// A bit that presses on its rock while it drills steadily.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pressed {
    pub(super) depth_m: f64,
    pub(super) weight_N: f64,
    /// Speed of the bit, motor included, rad/s.
    pub(super) turning_rad_per_s: f64,
}

/// A bit on its rock in a step that the rock is to end.
#[derive(Debug, Clone, Copy)]
struct Press {
    /// How far the bit would be past the front, m.
    over_m: f64,
    stiffness_N_per_m: f64,
    /// Velocity per axial force, s/kg.
    mobility_s_per_kg: f64,
    dt: f64,
}

impl Press {
    /// The weight at which the rock is compressed by as much as bit and front leave at the step's
    /// end, and the front's advance.
    fn on(&self, segments: impl IntoIterator<Item = RateSegment>) -> (f64, f64) {
        let (k, dt) = (self.stiffness_N_per_m, self.dt);
        let mut found = (0.0, 0.0);
        for s in segments {
            // W = k (over − dt · mobility · W − dt v(W)), on a straight stretch of v(W).
            let yielding = 1.0 + k * dt * (self.mobility_s_per_kg + s.slope_m_per_s_per_N);
            // Where the rate falls so steeply with the weight, more of it compresses the rock less.
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
    fn on_rate(&self, rate_m_per_s: impl Fn(f64) -> f64) -> (f64, f64) {
        if self.over_m.is_nan() || self.over_m <= 0.0 {
            return (0.0, 0.0);
        }
        let (k, dt) = (self.stiffness_N_per_m, self.dt);
        let yielding = (k * dt).mul_add(self.mobility_s_per_kg, 1.0);
        let advance = |weight: f64| dt * rate_m_per_s(weight).max(0.0);
        let excess = |weight: f64| yielding.mul_add(weight, k * (advance(weight) - self.over_m));
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

impl FrontCut {
    /// Gives a law of the caller's own that has been read back its own.
    pub(super) fn attach(&mut self, custom: &CustomLaw) -> Result<(), AnotherExtension> {
        match &mut self.law {
            FrontLaw::Custom(law) => law.attach(custom),
            _ => Ok(()),
        }
    }

    /// Whether a stored front is one of this law.
    pub(super) fn check(&self, law: &BitLaw) -> Result<(), Damaged> {
        let fits = match (&self.law, law) {
            (FrontLaw::Rate(_), BitLaw::Rate(_)) => true,
            (FrontLaw::DetournayDefourny(ours), BitLaw::DetournayDefourny(theirs)) => {
                ours == theirs
            }
            (FrontLaw::Table(ours, _), BitLaw::Table(theirs)) => ours == theirs,
            (FrontLaw::Custom(ours), BitLaw::Custom(_)) => ours.is_attached(),
            _ => false,
        };
        ensure(fits, "the law of the bit")
    }

    /// The front under a bit that drills steadily.
    pub(super) fn new(
        law: FrontLaw,
        stiffness_N_per_m: f64,
        shaker: Option<Shaker>,
        at: Pressed,
    ) -> Self {
        let mut cut = Self {
            law,
            stiffness_N_per_m,
            front_m: at.depth_m - at.weight_N / stiffness_N_per_m,
            weight_N: at.weight_N,
            shaker,
        };
        // The operation begins with its weight, wherever the excitation stands.
        cut.front_m -= cut.shake(at.turning_rad_per_s, 0.0, 0.0).front_m;
        cut
    }

    /// How often the bit was where its table is not, and how far.
    pub(super) fn table_use(&self) -> Option<TableUse> {
        match &self.law {
            FrontLaw::Table(law, used) => used.table_use(&law.table),
            _ => None,
        }
    }

    /// Counts anew.
    pub(super) fn restart(&mut self) {
        if let FrontLaw::Table(_, used) = &mut self.law {
            *used = Counter::new();
        }
    }

    fn shake(&self, turning: f64, turn_rad: f64, dt: f64) -> Shake {
        let own = match &self.law {
            FrontLaw::Custom(law) => law.shake(turn_rad, dt),
            _ => Shake::default(),
        };
        let Some(shaker) = &self.shaker else {
            return own;
        };
        match &self.law {
            FrontLaw::Custom(_) => {
                let noise = shaker.next(turn_rad, dt);
                Shake { front_m: own.front_m + noise.front_m, torque: own.torque + noise.torque }
            }
            FrontLaw::Table(law, _) => {
                shaker.next_of(law.spread(self.weight_N, turning), turn_rad, dt)
            }
            _ => shaker.next(turn_rad, dt),
        }
    }

    pub(super) fn meet(&mut self, at: &Approach, drive: &mut Drive) -> RockReaction {
        // The spin that the step gave without the rock is not the bit's: its torque is to come.
        let turning = at.spin_before_rad_per_s + drive.speed_rad_per_s();
        let shake = self.shake(turning, turning * at.dt, at.dt).plus(at.shake);
        let press = Press {
            over_m: at.depth_m - (self.front_m + shake.front_m),
            stiffness_N_per_m: self.stiffness_N_per_m,
            mobility_s_per_kg: at.axial_mobility_s_per_kg,
            dt: at.dt,
        };
        let (weight, advance) = match &self.law {
            FrontLaw::Rate(law) => press.on([law.segment(turning)]),
            FrontLaw::DetournayDefourny(law) => press.on(law.segments(turning)),
            FrontLaw::Table(law, _) => press.on(law.table.segments(turning)),
            FrontLaw::Custom(law) => press.on_rate(|weight| {
                let cut = law.cut(weight, turning);
                cut.rate_of_penetration_m_per_s
            }),
        };
        self.front_m += advance;
        self.weight_N = weight;
        let (steady, depth_of_cut_m) = match &mut self.law {
            FrontLaw::Rate(law) => (law.torque_N_m(weight), law.depth_of_cut_m(weight)),
            FrontLaw::DetournayDefourny(law) => {
                (law.torque_N_m(weight), law.depth_of_cut_m(weight))
            }
            FrontLaw::Table(law, used) => {
                used.count(&law.table, weight, turning);
                let cut = law.table.steady(weight, turning);
                (cut.torque_N_m, cut.depth_of_cut_m)
            }
            FrontLaw::Custom(law) => {
                let cut = law.cut(weight, turning);
                (cut.torque_N_m, cut.depth_of_cut_m)
            }
        };
        // A fluctuation never makes the rock turn the bit.
        let wanted = steady * (1.0 + shake.torque).max(0.0);
        let turned = self.turn(at, drive, wanted);
        if let Some(shaker) = &mut self.shaker {
            shaker.advance(turned.bit_rad_per_s * at.dt, at.dt);
        }
        if let FrontLaw::Custom(law) = &mut self.law {
            law.advance(&BitRockStep {
                dt_s: at.dt,
                weight_on_bit_N: weight,
                torque_N_m: turned.torque_N_m,
                bit_speed_rad_per_s: turned.bit_rad_per_s,
                advance_m: advance,
            });
        }
        RockReaction {
            weight_N: weight,
            torque_N_m: turned.torque_N_m,
            spin_rad_per_s: turned.string_rad_per_s,
            depth_of_cut_m,
            rate_m_per_s: advance / at.dt,
        }
    }

    /// Rock stops a bit but never turns it back; the reaction of a motor that does all the turning
    /// does turn the string.
    fn turn(&self, at: &Approach, drive: &mut Drive, wanted_N_m: f64) -> Turned {
        match &self.law {
            FrontLaw::Rate(law) if law.slides => {
                let string = at.spin_rad_per_s - at.turning_mobility * wanted_N_m;
                Turned {
                    torque_N_m: wanted_N_m,
                    string_rad_per_s: string,
                    bit_rad_per_s: string + drive.speed_rad_per_s(),
                }
            }
            _ => drive.turn(at.spin_rad_per_s, at.turning_mobility, wanted_N_m, 0.0),
        }
    }
}
