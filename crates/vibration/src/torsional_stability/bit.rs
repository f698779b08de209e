//! The law of the bit about steady drilling: how weight and torque answer small motions.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::StabilityError;
use crate::complex;
use wholestring::{
    dynamics::{BitLaw, BitSettings, Motor},
    operation::Operation,
};

/// Relative change of weight and speed over which a law's slopes are taken.
const STEP: f64 = 1e-5;

/// Response of the rock to a small motion of the bit along the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LinearRock {
    /// The bit does not move along the hole: its wear flats carry all the weight.
    Bears,
    /// A front on a spring that advances with the weight.
    Front {
        /// Stiffness of the contact, N/m.
        stiffness_N_per_m: f64,
        /// Increase of the rate of penetration per weight, m/s/N.
        rate_per_weight_m_per_s_per_N: f64,
    },
    /// The surface left by the blade before, a delay ago.
    Delay {
        /// Weight per depth of cut of one blade, N/m.
        stiffness_N_per_m: f64,
        /// Time from blade to blade, s.
        delay_s: f64,
    },
}

/// A bit that drills steadily, as small motions find it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearBit {
    /// Response of the rock along the hole.
    pub rock: LinearRock,
    /// Increase of the torque per weight, m.
    pub torque_per_weight_m: f64,
    /// Increase of the torque per speed at constant weight, N·m·s; negative for a bit whose torque
    /// falls with speed.
    pub torque_per_speed_N_m_s: f64,
    /// Advance per angle at constant weight, m/rad.
    pub advance_per_angle_m: f64,
    /// Decrease of a motor's speed per torque, rad/s/(N·m); zero without a motor of variable speed.
    pub motor_droop_rad_per_s_per_N_m: f64,
    /// Its torque, N·m.
    pub torque_N_m: f64,
    /// Its rate of penetration, m/s.
    pub rate_m_per_s: f64,
}

impl LinearBit {
    /// The bit of `settings` drilling `operation`, of which speed and weight are those that it
    /// drills at here and `case` holds those that its own torque and rate belong to.
    ///
    /// # Errors
    /// A bit on solid rock, or one that stalls its motor.
    pub(super) fn new(
        settings: &BitSettings,
        case: &Operation,
        operation: &Operation,
    ) -> Result<Self, StabilityError> {
        let weight = operation.weight_on_bit_N;
        let speed = settings.drilling_speed_rad_per_s(operation);
        if speed <= 0.0 {
            return Err(StabilityError::Stands);
        }
        let mut bit = match &settings.law {
            BitLaw::Rock(_) => return Err(StabilityError::SolidRock),
            BitLaw::Rate(law) => {
                // v = v₀ (W/W₀)(Ω/Ω₀), T = T₀ W/W₀.
                let own_speed = settings.drilling_speed_rad_per_s(case);
                let rate = case.rate_of_penetration_m_per_s / (case.weight_on_bit_N * own_speed);
                let torque_per_weight_m = case.bit_torque_N_m / case.weight_on_bit_N;
                Self {
                    rock: LinearRock::Front {
                        stiffness_N_per_m: law.rock_stiffness_N_per_m,
                        rate_per_weight_m_per_s_per_N: rate * speed,
                    },
                    torque_per_weight_m,
                    torque_per_speed_N_m_s: 0.0,
                    advance_per_angle_m: rate * weight,
                    motor_droop_rad_per_s_per_N_m: 0.0,
                    torque_N_m: torque_per_weight_m * weight,
                    rate_m_per_s: rate * weight * speed,
                }
            }
            BitLaw::Regenerative(law) => {
                let steady = law.steady(weight, speed);
                let cuts = steady.depth_of_cut_m > 0.0;
                let stiffness_N_per_m = law.stiffness_N_per_m();
                let delay_s = TAU / (f64::from(law.blades) * speed);
                Self {
                    rock: if cuts {
                        LinearRock::Delay { stiffness_N_per_m, delay_s }
                    } else {
                        LinearRock::Bears
                    },
                    torque_per_weight_m: law.cutters.torque_N_m(1.0, 0.0),
                    torque_per_speed_N_m_s: 0.0,
                    advance_per_angle_m: steady.depth_of_cut_m / TAU,
                    motor_droop_rad_per_s_per_N_m: 0.0,
                    torque_N_m: steady.torque_N_m,
                    rate_m_per_s: steady.rate_of_penetration_m_per_s,
                }
            }
            law => Self::measured(law, weight, speed).ok_or(StabilityError::SolidRock)?,
        };
        let turns =
            |torque: f64| settings.motor.speed_rad_per_s(operation.flow_now_m3_per_s(), torque);
        if settings.motor != Motor::Speed(0.0) {
            let step = STEP * bit.torque_N_m.max(1.0);
            let droop =
                (turns(bit.torque_N_m - step) - turns(bit.torque_N_m + step)) / (2.0 * step);
            bit.motor_droop_rad_per_s_per_N_m = droop;
        }
        Ok(bit)
    }

    /// The slopes of a law that gives rate and torque for weight and speed.
    fn measured(law: &BitLaw, weight: f64, speed: f64) -> Option<Self> {
        let here = law.steady(weight, speed)?;
        let by = |weight_step: f64, speed_step: f64| {
            let up = law.steady(weight + weight_step, speed + speed_step)?;
            let down = law.steady(weight - weight_step, speed - speed_step)?;
            let over = 2.0 * (weight_step + speed_step);
            let rate = up.rate_of_penetration_m_per_s - down.rate_of_penetration_m_per_s;
            Some([(up.torque_N_m - down.torque_N_m) / over, rate / over])
        };
        let [torque_per_weight_m, rate_per_weight_m_per_s_per_N] = by(STEP * weight, 0.0)?;
        let [torque_per_speed_N_m_s, advance_per_angle_m] = by(0.0, STEP * speed)?;
        Some(Self {
            rock: LinearRock::Front {
                stiffness_N_per_m: law.stiffness_N_per_m(),
                rate_per_weight_m_per_s_per_N,
            },
            torque_per_weight_m,
            torque_per_speed_N_m_s,
            advance_per_angle_m,
            motor_droop_rad_per_s_per_N_m: 0.0,
            torque_N_m: here.torque_N_m,
            rate_m_per_s: here.rate_of_penetration_m_per_s,
        })
    }

    /// Contribution of the bit to the determinant of the string, whose torsional and axial
    /// stiffness at the bit these are; `answered` is the contribution of an autodriller to the
    /// weight on the string's end.
    pub(super) fn close(
        &self,
        s: Complex<f64>,
        torsion: Complex<f64>,
        axial: Complex<f64>,
        answered: Complex<f64>,
    ) -> Complex<f64> {
        let gives = self.motor_droop_rad_per_s_per_N_m * self.torque_per_speed_N_m_s + 1.0;
        let turning = torsion + s * (self.torque_per_speed_N_m_s / gives);
        // W = A (u − ρ φ) of a front, W = k (1 − e^{−sτ}) (u − ρ φ) of the surface left by a blade.
        let pressed = match self.rock {
            LinearRock::Bears => return turning,
            LinearRock::Front { stiffness_N_per_m: k, rate_per_weight_m_per_s_per_N: rate } => {
                s * k / (s + k * rate)
            }
            LinearRock::Delay { stiffness_N_per_m: k, delay_s } => {
                (-complex::exp(-s * delay_s) + 1.0) * k
            }
        };
        let advance = self.advance_per_angle_m / gives;
        let torque = self.torque_per_weight_m / gives;
        // A motor under more torque turns slower, and so cuts less.
        let droop = self.motor_droop_rad_per_s_per_N_m;
        let own = -pressed * (advance * droop * self.torque_per_weight_m) / s + 1.0;
        turning * (axial * own + pressed * (answered + 1.0)) - axial * pressed * (torque * advance)
    }
}
