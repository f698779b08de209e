//! What circulation costs, and what the mud does to the whole string.

/// Mud forces on a whole string and the pressures that its flow takes.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct Hydraulics {
    /// What the mud's friction adds to the hook load, N: positive where the string is pulled out, negative
    /// where mud streams up along it.
    pub mud_drag_N: f64,
    /// What it adds to the surface torque, N·m.
    pub mud_torque_N_m: f64,
    /// Upward thrust of the bit's jets on the string, N.
    pub jet_thrust_N: f64,
    /// Friction in the bore, Pa.
    pub bore_loss_Pa: f64,
    /// Pressure drop of the bit, Pa.
    pub bit_loss_Pa: f64,
    /// Friction in the annulus, Pa: with the mud's weight, the pressure at the bottom.
    pub annulus_loss_Pa: f64,
    /// Pressure that the pump delivers at, Pa: the sum of the three.
    pub pump_pressure_Pa: f64,
}
