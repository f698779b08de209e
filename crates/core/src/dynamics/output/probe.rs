//! Quantities of single nodes against time.

use serde::{Deserialize, Serialize};

use super::frame::{FRAME, Frame};
use crate::outcome::signals;

signals! {
    /// A quantity of a node against time, read at the end of each sample but for the contact force.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
    pub enum NodeSignal of Frame in FRAME {
        /// Effective tension.
        Tension => tension_N;
        /// Torque.
        Torque => torque_N_m;
        /// Bending moment, whatever its direction.
        BendingMoment => bending_moment_N_m;
        /// Von Mises stress.
        VonMisesStress => von_mises_stress_Pa;
        /// Contact force, averaged over the sample; positive on the high side.
        ContactForce => contact_force_N;
        /// Offset from the hole's axis towards the high side.
        OffsetHigh => offset_high_m;
        /// Offset to the right of it.
        OffsetRight => offset_right_m;
        /// Velocity towards the high side.
        VelocityHigh => velocity_high_m_per_s;
        /// Velocity to the right of it.
        VelocityRight => velocity_right_m_per_s;
        /// Velocity down the hole.
        AxialVelocity => axial_velocity_m_per_s;
        /// Rotary speed.
        RotarySpeed => rotary_speed_rad_per_s;
    }
}

/// A place of the string that a quantity is recorded at.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    /// Measured depth with the bit at the operation's depth, m. The nearest node is taken, and
    /// moves with the string.
    pub md_m: f64,
    /// Recorded signal.
    pub signal: NodeSignal,
}

/// Record of a probe, one value per sample.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Probed {
    /// The node.
    pub node: usize,
    /// Recorded signal.
    pub signal: NodeSignal,
    /// Its samples.
    pub samples: Vec<f64>,
}
