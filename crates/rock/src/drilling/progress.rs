//! Progress of a bit.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::{Advance, Drilling};

/// Sums over an interval, and the means that drilling is judged by.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Progress {
    /// Time, s.
    pub time_s: f64,
    /// Depth drilled, m.
    pub depth_m: f64,
    /// Angle turned, rad.
    pub turned_rad: f64,
    /// Rock broken by the bit, at rest, m³.
    pub broken_m3: f64,
    /// Work of the bit on the rock, J.
    pub work_J: f64,
    /// Impulse of the rock on the bit, N·s.
    impulse_N_s: Vector3<f64>,
    /// Impulse of its moment, N·m·s.
    moment_N_m_s: Vector3<f64>,
    /// Squares of weight and torque over the time, N²·s and N²·m²·s.
    squares: [f64; 2],
}

impl Progress {
    /// Adds the result of the bit's motion over a time.
    pub fn add(&mut self, drilling: &Drilling, advance: &Advance) {
        let time_s = advance.time_s;
        self.time_s += time_s;
        self.depth_m += advance.displacement_m.z;
        self.turned_rad += advance.turned_rad;
        self.broken_m3 += advance.broken as f64 * drilling.block().grid().volume_m3();
        self.work_J -= advance.work_J;
        self.impulse_N_s += advance.force_N * time_s;
        self.moment_N_m_s += advance.moment_N_m * time_s;
        self.squares[0] += advance.force_N.z.powi(2) * time_s;
        self.squares[1] += advance.moment_N_m.z.powi(2) * time_s;
    }

    /// Mean rate of penetration, m/s.
    pub fn rate_m_per_s(&self) -> f64 {
        self.depth_m / self.time_s
    }

    /// Mean depth of cut per revolution, m.
    pub fn depth_of_cut_m(&self) -> f64 {
        self.depth_m * TAU / self.turned_rad
    }

    /// Mean weight on bit, N.
    pub fn weight_N(&self) -> f64 {
        -self.impulse_N_s.z / self.time_s
    }

    /// Standard deviation of the weight, means over the steps of the caller, N.
    pub fn weight_deviation_N(&self) -> f64 {
        (self.squares[0] / self.time_s - self.weight_N().powi(2)).max(0.0).sqrt()
    }

    /// Mean torque of the bit on the rock, N·m.
    pub fn torque_N_m(&self) -> f64 {
        -self.moment_N_m_s.z / self.time_s
    }

    /// Standard deviation of the torque, means over the steps of the caller, N·m.
    pub fn torque_deviation_N_m(&self) -> f64 {
        (self.squares[1] / self.time_s - self.torque_N_m().powi(2)).max(0.0).sqrt()
    }

    /// Work per broken volume, Pa.
    pub fn specific_energy_Pa(&self) -> f64 {
        self.work_J / self.broken_m3
    }
}
