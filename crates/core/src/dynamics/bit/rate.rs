//! The rate law: the bit cuts at a rate that is given.

use serde::{Deserialize, Serialize};

use super::{Answer, Approach, RateLaw, excitation::Shaker};
use crate::operation::{Operation, OperationKind};

/// The rock front that the bit cuts away.
///
/// The rock front lies where the bit has cut to. Pressed against it with the force `W`, the bit
/// advances it at the rate `v = v₀ (W/W₀)(Ω/Ω₀)`: the operation's rate of penetration at its weight
/// and speed. The bit leaves the rock freely. Its torque is proportional to its weight, `T = T₀ W/W₀`,
/// against the rotation, and holds the bit when the string no longer turns it. A sliding string's
/// bit is turned by its motor: the front advances at the motor's pace and the string carries the
/// reaction. An excitation raises and lowers the front under the bit.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct RateCut {
    stiffness_N_per_m: f64,
    /// Whether the string stands and a motor does all the turning.
    slides: bool,
    motor_rad_per_s: f64,
    /// Advance of the front per force and second at nominal speed, m/s/N.
    rate_m_per_s_per_N: f64,
    /// Torque per weight, m.
    torque_per_weight_m: f64,
    /// Speed of the bit, motor included, at which the rate holds.
    nominal_rad_per_s: f64,
    front_m: f64,
    shaker: Option<Shaker>,
}

impl RateCut {
    pub(super) fn new(
        law: RateLaw,
        motor_rad_per_s: f64,
        operation: &Operation,
        depth_m: f64,
        seed: u64,
    ) -> Self {
        let weight = operation.weight_on_bit_now_N();
        let shaker = law.excitation.map(|e| Shaker::new(e, seed));
        // The operation begins with its weight, wherever the excitation stands.
        let raised = shaker.as_ref().map_or(0.0, |s| s.next(0.0, 0.0).front_m);
        Self {
            stiffness_N_per_m: law.rock_stiffness_N_per_m,
            slides: operation.kind == OperationKind::Slide,
            motor_rad_per_s,
            rate_m_per_s_per_N: operation.rate_of_penetration_m_per_s / weight,
            torque_per_weight_m: operation.bit_torque_N_m / weight,
            nominal_rad_per_s: operation.rotation_rad_per_s() + motor_rad_per_s,
            front_m: depth_m - weight / law.rock_stiffness_N_per_m - raised,
            shaker,
        }
    }

    pub(super) fn meet(&mut self, at: &Approach) -> Answer {
        // The spin that the step gave without the rock is not the bit's: its torque is to come.
        let turning = at.spin_before_rad_per_s + self.motor_rad_per_s;
        let pace = if self.slides || self.nominal_rad_per_s == 0.0 {
            1.0
        } else {
            (turning / self.nominal_rad_per_s).max(0.0)
        };
        let shake = self
            .shaker
            .as_ref()
            .map_or_else(Default::default, |s| s.next(turning * at.dt, at.dt));
        let rate = self.rate_m_per_s_per_N * pace;
        let mobility = at.axial_mobility_s_per_kg;
        let k = self.stiffness_N_per_m;
        let front = self.front_m + shake.front_m;
        let weight = (k * (at.depth_m - front) / (1.0 + k * at.dt * (mobility + rate))).max(0.0);
        self.front_m += at.dt * rate * weight;

        let wanted = self.torque_per_weight_m * weight * (1.0 + shake.torque).max(0.0);
        // Rock stops a bit but never turns it back; a motor's reaction does turn the string.
        let torque = if self.slides {
            wanted
        } else {
            let turning = at.spin_rad_per_s + self.motor_rad_per_s;
            wanted.min(turning.max(0.0) / at.turning_mobility)
        };
        let spin = at.spin_rad_per_s - at.turning_mobility * torque;
        if let Some(shaker) = &mut self.shaker {
            shaker.advance((spin + self.motor_rad_per_s) * at.dt, at.dt);
        }
        // A motor whose speed nobody gave cuts something, but how much at a time is not known.
        let depth_of_cut_m = if self.nominal_rad_per_s > 0.0 {
            self.rate_m_per_s_per_N * weight * std::f64::consts::TAU / self.nominal_rad_per_s
        } else {
            0.0
        };
        Answer {
            weight_N: weight,
            torque_N_m: torque,
            spin_rad_per_s: spin,
            depth_of_cut_m,
        }
    }
}
