//! Which law the bit follows, and its numbers.

use serde::{Deserialize, Serialize};

use super::{
    CustomExcitation, CustomLaw, DetournayDefournyLaw, Motor, RateLaw, RegenerativeLaw, RockLaw,
    SteadyCut, TableLaw,
};
use crate::operation::Operation;

/// The bit on the rock.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BitSettings {
    /// How the rock answers.
    pub law: BitLaw,
    /// Lateral stiffness that holds the bit to the hole's axis, N/m. On solid rock the elements
    /// that it meets hold it besides.
    pub lateral_stiffness_N_per_m: f64,
    /// What the bit cuts sideways per force, over what it cuts along the hole per weight: its
    /// steerability. Zero of one that does not cut sideways.
    pub steerability: f64,
    /// What turns the bit against the string.
    pub motor: Motor,
    /// What shakes the bit besides its law, of the caller's own. Its name alone is serialised.
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
        match &self.law {
            BitLaw::Rate(law) => law.excitation.is_some() || self.excitation.is_some(),
            _ => true,
        }
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
    /// knows them from weight and speed; the rate law takes the operation's. With them comes what a
    /// motor takes off the mud.
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
        let knows = !matches!(self.law, BitLaw::Rate(_)) && operation.kind.on_bottom();
        if knows && other != *operation {
            self.drilling_steadily(other).rate_of_penetration_m_per_s
        } else {
            operation.axial_velocity_at_m_per_s(weight_on_bit_N, rotary_speed_rad_per_s)
        }
    }

    /// What the bit of an operation cuts sideways per force and angle, m/N/rad.
    pub(super) fn side_cut_m_per_N(&self, operation: &Operation) -> f64 {
        let speed = self.drilling_speed_rad_per_s(operation);
        let along = operation.rate_of_penetration_m_per_s / operation.weight_on_bit_N;
        if self.steerability > 0.0 && speed > 0.0 { self.steerability * along / speed } else { 0.0 }
    }
}

/// How the rock answers a bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum BitLaw {
    /// The operation's rate of penetration in proportion to weight and speed; torque in proportion
    /// to weight.
    Rate(RateLaw),
    /// Weight and torque from the depth of cut, which the bit's own passage before has left.
    Regenerative(RegenerativeLaw),
    /// Weight and torque from the depth of cut of a revolution, in three regimes.
    DetournayDefourny(DetournayDefournyLaw),
    /// Rate of penetration and torque as they were measured.
    Table(TableLaw),
    /// The face of the bit breaks solid rock.
    Rock(Box<RockLaw>),
    /// A law of the caller's own. Its name alone is serialised.
    #[serde(skip_deserializing)]
    Custom(CustomLaw),
}

impl BitLaw {
    /// Stiffness of the rock under the bit, N/m.
    pub fn stiffness_N_per_m(&self) -> f64 {
        match self {
            Self::Rate(law) => law.rock_stiffness_N_per_m,
            Self::Regenerative(law) => law.stiffness_N_per_m(),
            Self::DetournayDefourny(law) => law.rock_stiffness_N_per_m,
            Self::Table(law) => law.rock_stiffness_N_per_m,
            Self::Rock(law) => law.stiffness_N_per_m(),
            Self::Custom(law) => law.rock_stiffness_N_per_m,
        }
    }

    /// How a bit drills steadily under a weight on bit, turning at a speed; the rate law does not
    /// know, and of solid rock it is an [estimate](RockLaw::estimate).
    pub fn steady(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> Option<SteadyCut> {
        let (weight, speed) = (weight_on_bit_N, rotary_speed_rad_per_s);
        match self {
            Self::Rate(_) => None,
            Self::Regenerative(law) => Some(law.steady(weight, speed)),
            Self::DetournayDefourny(law) => Some(law.steady(weight, speed)),
            Self::Table(law) => Some(law.table.steady(weight, speed)),
            Self::Rock(law) => Some(law.steady(weight, speed)),
            Self::Custom(law) => Some(law.steady(weight, speed)),
        }
    }
}
