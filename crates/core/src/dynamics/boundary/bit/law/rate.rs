//! The rate law: the bit cuts at a rate that is given.

use serde::{Deserialize, Serialize};

use super::rules::{CutStart, LawRules};
use crate::{
    dynamics::{
        assemble::SetupError,
        boundary::bit::{
            cutters::SteadyCut,
            excitation::Excitation,
            front::{FrontCut, FrontRule, Press, check_front},
            motor::{Drive, Turned},
            rate_segment::RateSegment,
            step::Approach,
        },
    },
    operation::{Operation, OperationKind},
};

/// The rate law: the rock front is at the depth that the bit has cut, and under the force `W` the
/// bit advances at the rate `v = v₀ (W/W₀)(Ω/Ω₀)`, its torque is `T₀ W/W₀`; `v₀`, `W₀`, `Ω₀`, `T₀`
/// are the operation's.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RateLaw {
    /// Stiffness of the contact between bit and rock front, N/m.
    pub rock_stiffness_N_per_m: f64,
    /// Excitation of the bit; `None` for a smooth bottom.
    pub excitation: Option<Excitation>,
}

impl LawRules for RateLaw {
    type Cut = FrontCut<Rate>;

    fn check(&self) -> Result<(), SetupError> {
        check_front(self.rock_stiffness_N_per_m, self.excitation.as_ref())
    }

    fn stiffness_N_per_m(&self) -> f64 {
        self.rock_stiffness_N_per_m
    }

    fn steady_cut(&self, _weight_on_bit_N: f64, _rotary_speed_rad_per_s: f64) -> Option<SteadyCut> {
        None
    }

    fn counts_angle(&self) -> bool {
        self.excitation.is_some()
    }

    fn begin(&self, start: &CutStart<'_>) -> Option<Self::Cut> {
        let law = Rate::new(start.operation, start.drive);
        Some(FrontCut::new(law, self.rock_stiffness_N_per_m, self.excitation, start))
    }
}

/// The rate law with the numbers of an operation.
///
/// The torque holds the bit when the string no longer turns it. A sliding string's bit is turned by
/// its motor: the front advances at the motor's pace and the string carries the reaction.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Rate {
    /// Whether the string does not rotate and a motor, of which only the speed is known, provides
    /// all the rotation.
    slides: bool,
    /// Advance of the front per force and second at nominal speed, m/s/N.
    rate_m_per_s_per_N: f64,
    /// Torque per weight, m.
    torque_per_weight_m: f64,
    /// Speed of the bit, motor included, at which the rate holds.
    nominal_rad_per_s: f64,
}

impl Rate {
    fn new(operation: &Operation, drive: &Drive) -> Self {
        let weight = operation.weight_on_bit_now_N();
        Self {
            slides: operation.kind == OperationKind::Slide && drive.is_ideal(),
            rate_m_per_s_per_N: operation.rate_of_penetration_m_per_s / weight,
            torque_per_weight_m: operation.bit_torque_N_m / weight,
            nominal_rad_per_s: operation.rotation_rad_per_s() + drive.speed_rad_per_s(),
        }
    }

    fn segment(&self, speed_rad_per_s: f64) -> RateSegment {
        let speed_ratio = if self.slides || self.nominal_rad_per_s == 0.0 {
            1.0
        } else {
            (speed_rad_per_s / self.nominal_rad_per_s).max(0.0)
        };
        RateSegment {
            from_N: 0.0,
            to_N: f64::INFINITY,
            from_m_per_s: 0.0,
            slope_m_per_s_per_N: self.rate_m_per_s_per_N * speed_ratio,
        }
    }

    fn torque_N_m(&self, weight_N: f64) -> f64 {
        self.torque_per_weight_m * weight_N
    }

    /// Depth of cut under a weight; of a motor whose speed nobody gave it is not known, and zero.
    fn depth_of_cut_m(&self, weight_N: f64) -> f64 {
        if self.nominal_rad_per_s > 0.0 {
            self.rate_m_per_s_per_N * weight_N * std::f64::consts::TAU / self.nominal_rad_per_s
        } else {
            0.0
        }
    }
}

impl FrontRule for Rate {
    type Law = RateLaw;

    fn is_of(&self, _law: &RateLaw) -> bool {
        true
    }

    fn press(&self, press: &Press, turning_rad_per_s: f64) -> (f64, f64) {
        press.on([self.segment(turning_rad_per_s)])
    }

    fn cut(&mut self, weight_N: f64, _turning_rad_per_s: f64) -> (f64, f64) {
        (self.torque_N_m(weight_N), self.depth_of_cut_m(weight_N))
    }

    /// The reaction of a motor that does all the turning does turn the string.
    fn turn(&self, at: &Approach, drive: &mut Drive, required_N_m: f64) -> Turned {
        if !self.slides {
            return drive.turn(at.spin_rad_per_s, at.turning_mobility, required_N_m, 0.0);
        }
        let string = at.spin_rad_per_s - at.turning_mobility * required_N_m;
        Turned {
            torque_N_m: required_N_m,
            string_rad_per_s: string,
            bit_rad_per_s: string + drive.speed_rad_per_s(),
        }
    }
}
