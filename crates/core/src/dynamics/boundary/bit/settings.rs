//! Which law the bit follows, and its numbers.

use serde::{Deserialize, Serialize};

use super::{
    CustomExcitation,
    law::{BitLaw, RateLaw},
    motor::Motor,
};
use crate::operation::Operation;

/// The bit on the rock.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BitSettings {
    /// Law of the rock's reaction.
    pub law: BitLaw,
    /// Lateral stiffness that holds the bit to the hole's axis, N/m. On solid rock the elements
    /// that it meets hold it besides.
    pub lateral_stiffness_N_per_m: f64,
    /// Steerability of the bit: its lateral cut per force over its axial cut per weight. Zero for a
    /// bit that does not cut sideways.
    pub steerability: f64,
    /// Motor that turns the bit against the string.
    pub motor: Motor,
    /// User-defined excitation in addition to that of the law. Only its name is serialised.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub excitation: Option<CustomExcitation>,
}

impl Default for BitSettings {
    /// The rate law on rock of 1e8 N/m without excitation, 1e7 N/m across and no side cutting, no
    /// motor.
    fn default() -> Self {
        Self {
            law: BitLaw::Rate(RateLaw { rock_stiffness_N_per_m: 1e8, excitation: None }),
            lateral_stiffness_N_per_m: 1e7,
            steerability: 0.0,
            motor: Motor::Speed(0.0),
            excitation: None,
        }
    }
}

impl BitSettings {
    /// Whether the speed of a sliding string's motor makes a difference: where the bit's angle
    /// counts.
    pub fn needs_motor_speed(&self) -> bool {
        self.law.counts_angle() || self.excitation.is_some()
    }

    /// Rotary speed at which the bit drills an operation steadily, its motor's included, rad/s;
    /// zero where it stalls the motor.
    pub fn drilling_speed_rad_per_s(&self, operation: &Operation) -> f64 {
        let weight = operation.weight_on_bit_N;
        self.motor.steady_rad_per_s(
            operation.flow_now_m3_per_s(),
            operation.rotation_rad_per_s(),
            |speed| match self.law.steady(weight, speed) {
                Some(cut) => cut.torque_N_m,
                None => operation.bit_torque_N_m,
            },
        )
    }

    /// The operation with the torque and the rate of penetration of steady drilling, where the law
    /// computes them from weight and speed; the rate law takes the operation's. They include the
    /// pressure that a motor takes from the mud.
    #[must_use]
    pub fn drilling_steadily(&self, mut operation: Operation) -> Operation {
        let speed = self.drilling_speed_rad_per_s(&operation);
        if let Some(steady) = self.law.steady(operation.weight_on_bit_N, speed) {
            operation.bit_torque_N_m = steady.torque_N_m.min(self.motor.max_torque_N_m());
            operation.rate_of_penetration_m_per_s = steady.rate_of_penetration_m_per_s;
        }
        let pressure_Pa = self.motor.pressure_Pa(operation.bit_torque_N_m);
        operation.motor_pressure_drop_Pa = pressure_Pa.unwrap_or(0.0);
        operation
    }

    /// Axial speed of the string at another weight on bit and rotary speed, m/s, positive towards
    /// the bit: on bottom by the law, which for the rate law is in proportion to both.
    pub fn axial_velocity_m_per_s(
        &self,
        operation: &Operation,
        weight_on_bit_N: f64,
        rotary_speed_rad_per_s: f64,
    ) -> f64 {
        let other = Operation { weight_on_bit_N, rotary_speed_rad_per_s, ..*operation };
        let knows = self.law.steady(weight_on_bit_N, rotary_speed_rad_per_s).is_some();
        if knows && operation.kind.on_bottom() && other != *operation {
            self.drilling_steadily(other).rate_of_penetration_m_per_s
        } else {
            operation.axial_velocity_at_m_per_s(weight_on_bit_N, rotary_speed_rad_per_s)
        }
    }

    /// Lateral cut of the bit of an operation per force and angle, m/N/rad.
    pub(super) fn side_cut_m_per_N(&self, operation: &Operation) -> f64 {
        let speed = self.drilling_speed_rad_per_s(operation);
        let along = operation.rate_of_penetration_m_per_s / operation.weight_on_bit_N;
        if self.steerability > 0.0 && speed > 0.0 { self.steerability * along / speed } else { 0.0 }
    }
}
