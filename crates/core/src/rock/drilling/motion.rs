//! How the bit is moved, and how it moves on.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// What the bit opposes to a push. An infinite inertia goes as it is told.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Inertia {
    /// Mass along the hole, kg.
    pub mass_kg: f64,
    /// Mass across it, kg.
    pub lateral_mass_kg: f64,
    /// Moment of inertia about the hole's axis, kg·m².
    pub about_axis_kg_m2: f64,
}

impl Inertia {
    /// A bit that goes as it is told.
    pub const TOLD: Self = Self {
        mass_kg: f64::INFINITY,
        lateral_mass_kg: f64::INFINITY,
        about_axis_kg_m2: f64::INFINITY,
    };

    /// What an impulse changes.
    pub(super) fn mobilities(&self) -> [Vector3<f64>; 2] {
        let across = 1.0 / self.lateral_mass_kg;
        [
            Vector3::new(across, across, 1.0 / self.mass_kg),
            Vector3::new(0.0, 0.0, 1.0 / self.about_axis_kg_m2),
        ]
    }
}

/// What a bit comes with, in the frame of the hole: z down along it. It tilts as it is told.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BitMotion {
    /// Velocity of the bit's reference point, m/s.
    pub velocity_m_per_s: Vector3<f64>,
    /// Angular velocity, rad/s; positive about z is clockwise, looking down.
    pub angular_velocity_rad_per_s: Vector3<f64>,
    /// What pushes the bit besides the rock, N, the same all the time.
    pub force_N: Vector3<f64>,
    /// Moment on the bit besides the rock's, N·m.
    pub moment_N_m: Vector3<f64>,
    /// What it opposes.
    pub inertia: Inertia,
}

/// What became of the bit in a time.
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
    /// Angle turned about the hole's axis, rad.
    pub turned_rad: f64,
    /// Mean force of the rock on the bit, N.
    pub force_N: Vector3<f64>,
    /// Mean moment of the rock on the bit about its reference point, N·m.
    pub moment_N_m: Vector3<f64>,
    /// Work of the rock on the bit, J; negative while it drills.
    pub work_J: f64,
    /// Bricks that the bit has broken.
    pub broken: usize,
}
