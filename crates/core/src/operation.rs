//! What the driller is doing.

mod set_points;

use serde::Serialize;

use crate::named::named;

named! {
    /// The operations that torque and drag are computed for.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
    pub enum OperationKind {
        /// Pulling the string out of the hole without rotation.
        TripOut = "trip_out",
        /// Running the string into the hole without rotation.
        TripIn = "trip_in",
        /// Rotating with the bit off bottom and no axial motion.
        RotateOffBottom = "rotate_off_bottom",
        /// Rotary drilling: rotating and advancing with weight on the bit.
        Drill = "drill",
        /// Advancing with weight on the bit without rotating the string (mud motor).
        Slide = "slide",
        /// Rotating while running in, off bottom.
        Ream = "ream",
        /// Rotating while pulling out, off bottom.
        BackReam = "back_ream",
    }
}

impl OperationKind {
    /// The operation of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Whether the whole string turns.
    pub const fn rotates(self) -> bool {
        matches!(self, Self::RotateOffBottom | Self::Drill | Self::Ream | Self::BackReam)
    }

    /// Whether the bit is on bottom and cuts.
    pub const fn on_bottom(self) -> bool {
        matches!(self, Self::Drill | Self::Slide)
    }
}

/// One operation with its set points, as the driller gives them.
///
/// Every set point is kept whatever the kind; the accessors below say what the kind makes of them
/// (a tripping string does not turn, whatever `rotary_speed_rad_per_s` says).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Operation {
    /// What is being done.
    pub kind: OperationKind,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Rotary speed at surface when the string turns, rad/s, clockwise looking down the hole.
    pub rotary_speed_rad_per_s: f64,
    /// Weight on bit when the bit is on bottom, N, positive in compression.
    pub weight_on_bit_N: f64,
    /// Torque of the bit at `weight_on_bit_N`, N·m.
    pub bit_torque_N_m: f64,
    /// Rate of penetration at `weight_on_bit_N` and `rotary_speed_rad_per_s`, m/s.
    pub rate_of_penetration_m_per_s: f64,
    /// Axial speed of tripping and reaming, m/s, positive.
    pub trip_speed_m_per_s: f64,
    /// What the pumps deliver while they run, m³/s.
    pub flow_rate_m3_per_s: f64,
    /// Pressure drop of the bit's nozzles at that flow rate, Pa.
    pub bit_pressure_drop_Pa: f64,
    /// Pressure drop of a mud motor that gives `bit_torque_N_m`, Pa.
    pub motor_pressure_drop_Pa: f64,
}

impl Operation {
    /// Rotary speed of the string, rad/s; zero where the kind does not rotate.
    pub fn rotation_rad_per_s(&self) -> f64 {
        if self.kind.rotates() { self.rotary_speed_rad_per_s } else { 0.0 }
    }

    /// Axial speed of the string, m/s, positive towards the bit.
    pub fn axial_velocity_m_per_s(&self) -> f64 {
        match self.kind {
            OperationKind::TripOut | OperationKind::BackReam => -self.trip_speed_m_per_s,
            OperationKind::TripIn | OperationKind::Ream => self.trip_speed_m_per_s,
            OperationKind::RotateOffBottom => 0.0,
            OperationKind::Drill | OperationKind::Slide => self.rate_of_penetration_m_per_s,
        }
    }

    /// Axial speed of the string at another weight on bit and rotary speed, m/s, positive towards
    /// the bit: on bottom in proportion to both, but that a motor turns the bit of a string that
    /// slides.
    pub fn axial_velocity_at_m_per_s(
        &self,
        weight_on_bit_N: f64,
        rotary_speed_rad_per_s: f64,
    ) -> f64 {
        let part = |value: f64, of: f64| if of > 0.0 { value / of } else { 1.0 };
        let cutting =
            if self.kind.on_bottom() { part(weight_on_bit_N, self.weight_on_bit_N) } else { 1.0 };
        let turning = if self.kind.on_bottom() && self.kind.rotates() {
            part(rotary_speed_rad_per_s, self.rotary_speed_rad_per_s)
        } else {
            1.0
        };
        self.axial_velocity_m_per_s() * cutting * turning
    }

    /// Weight on bit, N; zero off bottom.
    pub fn weight_on_bit_now_N(&self) -> f64 {
        if self.kind.on_bottom() { self.weight_on_bit_N } else { 0.0 }
    }

    /// Bit torque that the string carries, N·m; zero off bottom. A sliding string carries the
    /// reaction of its motor, which is the same torque.
    pub fn bit_torque_now_N_m(&self) -> f64 {
        if self.kind.on_bottom() { self.bit_torque_N_m } else { 0.0 }
    }

    /// What the pumps deliver, m³/s; zero while the string trips without rotation, for the top
    /// drive is off it.
    pub fn flow_now_m3_per_s(&self) -> f64 {
        match self.kind {
            OperationKind::TripOut | OperationKind::TripIn => 0.0,
            _ => self.flow_rate_m3_per_s,
        }
    }

    /// Pressure drop of a mud motor, Pa; zero off bottom, where the bit takes no torque.
    pub fn motor_loss_Pa(&self) -> f64 {
        if self.kind.on_bottom() { self.motor_pressure_drop_Pa } else { 0.0 }
    }

    /// Pressure drop of the nozzles at a flow rate, Pa: by its square.
    pub fn bit_loss_Pa(&self, flow_m3_per_s: f64) -> f64 {
        if self.flow_rate_m3_per_s > 0.0 {
            self.bit_pressure_drop_Pa * (flow_m3_per_s / self.flow_rate_m3_per_s).powi(2)
        } else {
            0.0
        }
    }
}
