//! Motion of the bit and its integration.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// Inertia of the bit. With an infinite inertia the motion is as prescribed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Inertia {
    /// Mass along `along`, kg.
    pub mass_kg: f64,
    /// Mass across it, kg.
    pub lateral_mass_kg: f64,
    /// A unit vector of the hole's frame: z, or another direction for a string that leans in its
    /// hole.
    pub along: Vector3<f64>,
    /// Moment of inertia about the bit's axis, kg·m².
    pub about_axis_kg_m2: f64,
    /// Moment of inertia across the bit's axis, kg·m².
    pub across_axis_kg_m2: f64,
}

impl Inertia {
    /// A bit that goes as prescribed.
    pub const PRESCRIBED: Self = Self {
        mass_kg: f64::INFINITY,
        lateral_mass_kg: f64::INFINITY,
        along: Vector3::new(0.0, 0.0, 1.0),
        about_axis_kg_m2: f64::INFINITY,
        across_axis_kg_m2: f64::INFINITY,
    };

    /// Change of the velocity by an impulse, N·s, in m/s.
    pub fn velocity_change_m_per_s(&self, impulse_N_s: Vector3<f64>) -> Vector3<f64> {
        let along = self.along * self.along.dot(&impulse_N_s);
        along / self.mass_kg + (impulse_N_s - along) / self.lateral_mass_kg
    }

    /// The impulse, N·s, that changes the velocity so, m/s.
    pub fn impulse_N_s(&self, change_m_per_s: Vector3<f64>) -> Vector3<f64> {
        let along = self.along * self.along.dot(&change_m_per_s);
        along * self.mass_kg + (change_m_per_s - along) * self.lateral_mass_kg
    }

    /// Change of the angular velocity, rad/s, of a bit with an axis by the impulse of a moment,
    /// N·m·s.
    pub(super) fn turned(&self, impulse_N_m_s: Vector3<f64>, axis: &Vector3<f64>) -> Vector3<f64> {
        let about = axis * axis.dot(&impulse_N_m_s);
        about / self.about_axis_kg_m2 + (impulse_N_m_s - about) / self.across_axis_kg_m2
    }
}

/// Initial motion and loads of a bit, in the frame of the hole: z down along it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BitMotion {
    /// Velocity of the bit's reference point, m/s.
    pub velocity_m_per_s: Vector3<f64>,
    /// Angular velocity, rad/s; positive about z is clockwise, looking down.
    pub angular_velocity_rad_per_s: Vector3<f64>,
    /// Constant force on the bit in addition to that of the rock, N.
    pub force_N: Vector3<f64>,
    /// Moment on the bit besides the rock's, N·m.
    pub moment_N_m: Vector3<f64>,
    /// Inertia of the bit.
    pub inertia: Inertia,
}

/// Result of the bit's motion over a time.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Advance {
    /// The time, s.
    pub time_s: f64,
    /// Velocity of the bit's reference point at the end, m/s.
    pub velocity_m_per_s: Vector3<f64>,
    /// Angular velocity at the end, rad/s.
    pub angular_velocity_rad_per_s: Vector3<f64>,
    /// Way of the reference point, m.
    pub displacement_m: Vector3<f64>,
    /// Angle turned about the bit's axis, rad.
    pub turned_rad: f64,
    /// Mean force of the rock on the bit, N.
    pub force_N: Vector3<f64>,
    /// Mean moment of the rock on the bit about its reference point, N·m.
    pub moment_N_m: Vector3<f64>,
    /// Work of the rock on the bit, J; negative while it drills.
    pub work_J: f64,
    /// Elements that the bit has broken.
    pub broken: usize,
}

impl Advance {
    /// Appends the result of the time that follows: forces and moments are means over both.
    pub fn join(&mut self, next: &Self) {
        let time_s = self.time_s + next.time_s;
        let mean = |before: Vector3<f64>, after: Vector3<f64>| {
            (before * self.time_s + after * next.time_s) / time_s
        };
        *self = Self {
            time_s,
            force_N: mean(self.force_N, next.force_N),
            moment_N_m: mean(self.moment_N_m, next.moment_N_m),
            displacement_m: self.displacement_m + next.displacement_m,
            turned_rad: self.turned_rad + next.turned_rad,
            work_J: self.work_J + next.work_J,
            broken: self.broken + next.broken,
            ..*next
        };
    }
}
