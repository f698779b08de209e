//! Pressure losses of circulation, and effect of the mud on the whole string.

use std::ops::{Add, Mul};

/// Mud forces on a whole string and the pressures that its flow takes.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct Hydraulics {
    /// Contribution of the mud's friction to the hook load, N: positive where the string is pulled
    /// out, negative where mud streams up along it.
    #[serde(with = "crate::finite")]
    pub mud_drag_N: f64,
    /// Contribution to the surface torque, N·m.
    #[serde(with = "crate::finite")]
    pub mud_torque_N_m: f64,
    /// Upward thrust of the bit's jets on the string, N.
    #[serde(with = "crate::finite")]
    pub jet_thrust_N: f64,
    /// Friction in the bore, Pa.
    #[serde(with = "crate::finite")]
    pub bore_loss_Pa: f64,
    /// Pressure drop of the bit, Pa.
    #[serde(with = "crate::finite")]
    pub bit_loss_Pa: f64,
    /// Pressure drop of a mud motor, Pa.
    #[serde(default)]
    #[serde(with = "crate::finite")]
    pub motor_loss_Pa: f64,
    /// Friction in the annulus, Pa: with the mud's weight, the pressure at the bottom.
    #[serde(with = "crate::finite")]
    pub annulus_loss_Pa: f64,
    /// Pressure that the pump delivers at, Pa: the sum of the four.
    #[serde(with = "crate::finite")]
    pub pump_pressure_Pa: f64,
}

/// A number of [`Hydraulics`] and its plausible range.
pub type PlausibleRange = (&'static str, fn(&Hydraulics) -> f64, [f64; 2]);

/// Greatest pressure that a number of [`Hydraulics`] may have, Pa: ten times the pressure of the
/// strongest mud pumps.
const MAX_PRESSURE: f64 = 1e9;

/// Greatest force, N: that of the heaviest hoists, and of no mud.
const MAX_FORCE: f64 = 1e8;

/// Greatest torque, N·m.
const MAX_TORQUE: f64 = 1e7;

impl Hydraulics {
    /// Plausible range of each number in a string that lets mud pass. Pressures may be negative,
    /// because a string that is pulled out swabs.
    pub const PLAUSIBLE: [PlausibleRange; 8] = [
        ("mud_drag_N", |mud| mud.mud_drag_N, [-MAX_FORCE, MAX_FORCE]),
        ("mud_torque_N_m", |mud| mud.mud_torque_N_m, [-MAX_TORQUE, MAX_TORQUE]),
        ("jet_thrust_N", |mud| mud.jet_thrust_N, [0.0, MAX_FORCE]),
        ("bore_loss_Pa", |mud| mud.bore_loss_Pa, [0.0, MAX_PRESSURE]),
        ("bit_loss_Pa", |mud| mud.bit_loss_Pa, [0.0, MAX_PRESSURE]),
        ("motor_loss_Pa", |mud| mud.motor_loss_Pa, [0.0, MAX_PRESSURE]),
        ("annulus_loss_Pa", |mud| mud.annulus_loss_Pa, [-MAX_PRESSURE, MAX_PRESSURE]),
        ("pump_pressure_Pa", |mud| mud.pump_pressure_Pa, [-MAX_PRESSURE, MAX_PRESSURE]),
    ];

    /// The first implausible number: its name and value.
    pub fn implausible(&self) -> Option<(&'static str, f64)> {
        let values =
            Self::PLAUSIBLE.iter().map(|(name, value, range)| (*name, value(self), *range));
        let mut beyond =
            values.filter(|(_, value, [least, most])| !(*least..=*most).contains(value));
        beyond.next().map(|(name, value, _)| (name, value))
    }

    /// Each number of this and the other, joined.
    fn join(self, other: Self, join: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            mud_drag_N: join(self.mud_drag_N, other.mud_drag_N),
            mud_torque_N_m: join(self.mud_torque_N_m, other.mud_torque_N_m),
            jet_thrust_N: join(self.jet_thrust_N, other.jet_thrust_N),
            bore_loss_Pa: join(self.bore_loss_Pa, other.bore_loss_Pa),
            bit_loss_Pa: join(self.bit_loss_Pa, other.bit_loss_Pa),
            motor_loss_Pa: join(self.motor_loss_Pa, other.motor_loss_Pa),
            annulus_loss_Pa: join(self.annulus_loss_Pa, other.annulus_loss_Pa),
            pump_pressure_Pa: join(self.pump_pressure_Pa, other.pump_pressure_Pa),
        }
    }
}

impl Add for Hydraulics {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.join(other, |a, b| a + b)
    }
}

impl Mul<f64> for Hydraulics {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self.join(self, |own, _| own * factor)
    }
}
