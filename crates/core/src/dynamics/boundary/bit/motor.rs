//! Mud motor that turns the bit against the string.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

/// The motor between string and bit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Motor {
    /// It turns the bit at this speed against the string, rad/s, whatever the torque; zero without
    /// a motor.
    Speed(f64),
    /// It turns as flow and torque let it.
    Displacement(MudMotor),
}

/// A positive displacement motor.
///
/// `T = η V p/2π` at the pressure drop `p`, `Ω = 2π (Q − q(T))/V` at the flow `Q`, with a leak `q`
/// that is linear in the torque below the largest pressure and above it, up to the stall. Theory:
/// `docs/src/theory/bit.md`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MudMotor {
    /// Volume per revolution `V`, m³.
    pub displacement_m3: f64,
    /// Flow at which slip and stall were measured, m³/s.
    pub rated_flow_m3_per_s: f64,
    /// Largest pressure drop that it is made for, Pa.
    pub max_pressure_Pa: f64,
    /// Part `s` of the rated flow that leaks past it at that pressure.
    pub slip: f64,
    /// Part `η` of the ideal torque that reaches the bit.
    pub efficiency: f64,
    /// Torque at which it stalls, N·m.
    pub stall_torque_N_m: f64,
}

impl MudMotor {
    /// Torque at a pressure drop, N·m.
    pub fn torque_N_m(&self, pressure_Pa: f64) -> f64 {
        self.efficiency * self.displacement_m3 * pressure_Pa / TAU
    }

    /// Pressure drop at a torque, Pa.
    pub fn pressure_Pa(&self, torque_N_m: f64) -> f64 {
        torque_N_m * TAU / (self.efficiency * self.displacement_m3)
    }

    /// Torque at the largest pressure drop that it is made for, N·m.
    pub fn max_torque_N_m(&self) -> f64 {
        self.torque_N_m(self.max_pressure_Pa)
    }

    /// Speed against the string at a flow rate and a torque, rad/s; negative where the torque turns
    /// it back.
    pub fn speed_rad_per_s(&self, flow_m3_per_s: f64, torque_N_m: f64) -> f64 {
        TAU * (flow_m3_per_s - self.leak_m3_per_s(torque_N_m)) / self.displacement_m3
    }

    fn leak_m3_per_s(&self, torque_N_m: f64) -> f64 {
        let [from, to] = self.segment(torque_N_m <= self.max_torque_N_m());
        let part = (torque_N_m.max(0.0) - from.0) / (to.0 - from.0);
        from.1 + part * (to.1 - from.1)
    }

    /// The ends of a straight part of the leak, torque and flow: below the largest pressure, or
    /// above.
    fn segment(&self, below: bool) -> [(f64, f64); 2] {
        let rated = (self.max_torque_N_m(), self.slip * self.rated_flow_m3_per_s);
        if below {
            [(0.0, 0.0), rated]
        } else {
            [rated, (self.stall_torque_N_m, self.rated_flow_m3_per_s)]
        }
    }

    /// Torque that stops a bit that turns at `turning_rad_per_s` without one, each unit of torque
    /// slowing the string under it by `mobility`; no more than the stall torque.
    fn holding_N_m(&self, flow_m3_per_s: f64, spin_rad_per_s: f64, mobility: f64) -> f64 {
        let turning = |torque: f64| {
            spin_rad_per_s - mobility * torque + self.speed_rad_per_s(flow_m3_per_s, torque)
        };
        // The speed of the bit falls along each straight part: it stops where the speed crosses
        // zero.
        for below in [true, false] {
            let [(from, _), (to, _)] = self.segment(below);
            let (fast, slow) = (turning(from), turning(to));
            if fast <= 0.0 {
                return from;
            }
            if slow <= 0.0 {
                return from + (to - from) * fast / (fast - slow);
            }
        }
        self.stall_torque_N_m
    }
}

/// The motor as it runs.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Drive {
    motor: Motor,
    flow_m3_per_s: f64,
    speed_rad_per_s: f64,
}

/// Rotation of string and bit under a torque between them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turned {
    /// Against the string's rotation.
    pub(super) torque_N_m: f64,
    pub(super) string_rad_per_s: f64,
    /// Exactly zero of a bit that the rock holds.
    pub(super) bit_rad_per_s: f64,
}

impl Motor {
    /// Speed against the string at a flow rate and a torque, rad/s.
    pub fn speed_rad_per_s(&self, flow_m3_per_s: f64, torque_N_m: f64) -> f64 {
        match self {
            Self::Speed(speed) => *speed,
            Self::Displacement(motor) => motor.speed_rad_per_s(flow_m3_per_s, torque_N_m),
        }
    }

    /// Pressure that it takes off the mud at a torque, Pa, where that is known.
    pub fn pressure_Pa(&self, torque_N_m: f64) -> Option<f64> {
        match self {
            Self::Speed(_) => None,
            Self::Displacement(motor) => Some(motor.pressure_Pa(torque_N_m)),
        }
    }

    /// Torque that it turns the bit with at the most, N·m.
    pub fn max_torque_N_m(&self) -> f64 {
        match self {
            Self::Speed(_) => f64::INFINITY,
            Self::Displacement(motor) => motor.stall_torque_N_m,
        }
    }

    /// Speed at which a bit drills steadily under a string that turns at `string_rad_per_s`, rad/s,
    /// where its torque is `torque_N_m` of its speed; zero where that torque stalls the motor.
    pub(super) fn steady_rad_per_s(
        &self,
        flow_m3_per_s: f64,
        string_rad_per_s: f64,
        torque_N_m: impl Fn(f64) -> f64,
    ) -> f64 {
        let speed = |torque| string_rad_per_s + self.speed_rad_per_s(flow_m3_per_s, torque);
        let Self::Displacement(motor) = self else {
            return speed(0.0);
        };
        let turns = |torque: f64| speed(torque) > 0.0 && torque_N_m(speed(torque)) <= torque;
        let (mut less, mut more) = (0.0, motor.stall_torque_N_m);
        if torque_N_m(0.0) > more {
            return 0.0;
        }
        // Halved until the speed is known to its last digits.
        for _ in 0..60 {
            let middle = 0.5 * (less + more);
            if turns(middle) || speed(middle) <= 0.0 {
                more = middle;
            } else {
                less = middle;
            }
        }
        speed(more).max(0.0)
    }
}

impl Drive {
    /// The motor turning at the speed that it has under a torque.
    pub(super) fn new(motor: Motor, flow_m3_per_s: f64, torque_N_m: f64) -> Self {
        Self {
            motor,
            flow_m3_per_s,
            speed_rad_per_s: motor.speed_rad_per_s(flow_m3_per_s, torque_N_m),
        }
    }

    pub(super) fn set_flow(&mut self, flow_m3_per_s: f64) {
        self.flow_m3_per_s = flow_m3_per_s;
    }

    /// Speed against the string, rad/s.
    pub(super) fn speed_rad_per_s(&self) -> f64 {
        self.speed_rad_per_s
    }

    /// Whether nothing is known of it but, perhaps, its speed.
    pub(super) fn is_ideal(&self) -> bool {
        matches!(self.motor, Motor::Speed(_))
    }

    /// Nothing resists the bit.
    pub(super) fn run_free(&mut self) {
        self.speed_rad_per_s = self.motor.speed_rad_per_s(self.flow_m3_per_s, 0.0);
    }

    /// The bit resists with a torque, N·m: the motor turns at the speed that it has under it.
    pub(super) fn resist(&mut self, torque_N_m: f64) {
        self.speed_rad_per_s = self.motor.speed_rad_per_s(self.flow_m3_per_s, torque_N_m);
    }

    /// Turns a bit that resists with up to `forward_N_m` when it turns forward and up to `back_N_m`
    /// when it turns back. `spin_rad_per_s` is the string's without any torque, `mobility` its spin
    /// per torque.
    pub(super) fn turn(
        &mut self,
        spin_rad_per_s: f64,
        mobility: f64,
        forward_N_m: f64,
        back_N_m: f64,
    ) -> Turned {
        self.run_free();
        let free = spin_rad_per_s + self.speed_rad_per_s;
        let (most, stops) = match self.motor {
            // Turned back by the string: the rock resists the other way.
            _ if free < 0.0 => (-back_N_m, free / mobility),
            Motor::Speed(_) => (forward_N_m, free / mobility),
            Motor::Displacement(motor) => {
                (forward_N_m, motor.holding_N_m(self.flow_m3_per_s, spin_rad_per_s, mobility))
            }
        };
        let holds = stops.abs() <= most.abs();
        let torque_N_m = if holds { stops } else { most };
        let string_rad_per_s = spin_rad_per_s - mobility * torque_N_m;
        if holds {
            // Held is held: a rounding error would turn it back.
            let string_rad_per_s = match self.motor {
                Motor::Speed(speed) => -speed,
                Motor::Displacement(_) => string_rad_per_s,
            };
            self.speed_rad_per_s = match self.motor {
                Motor::Speed(speed) => speed,
                Motor::Displacement(_) => -string_rad_per_s,
            };
            return Turned { torque_N_m, string_rad_per_s, bit_rad_per_s: 0.0 };
        }
        self.speed_rad_per_s = self.motor.speed_rad_per_s(self.flow_m3_per_s, torque_N_m);
        Turned {
            torque_N_m,
            string_rad_per_s,
            bit_rad_per_s: string_rad_per_s + self.speed_rad_per_s,
        }
    }
}
