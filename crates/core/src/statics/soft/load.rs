//! Quantities accumulated along the string, and the wall load at a point.

use std::ops::{Add, Mul};

use nalgebra::Vector3;

use crate::well::Heading;

/// Totals accumulated from the bit up. Its derivative has the same fields, per metre upwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Totals {
    pub(super) tension_N: f64,
    pub(super) torque_N_m: f64,
    pub(super) axial_friction_N: f64,
    pub(super) side_force_N: f64,
    pub(super) stretch_m: f64,
    pub(super) twist_rad: f64,
}

impl Add for Totals {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            tension_N: self.tension_N + other.tension_N,
            torque_N_m: self.torque_N_m + other.torque_N_m,
            axial_friction_N: self.axial_friction_N + other.axial_friction_N,
            side_force_N: self.side_force_N + other.side_force_N,
            stretch_m: self.stretch_m + other.stretch_m,
            twist_rad: self.twist_rad + other.twist_rad,
        }
    }
}

impl Mul<f64> for Totals {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self {
            tension_N: self.tension_N * factor,
            torque_N_m: self.torque_N_m * factor,
            axial_friction_N: self.axial_friction_N * factor,
            side_force_N: self.side_force_N * factor,
            stretch_m: self.stretch_m * factor,
            twist_rad: self.twist_rad * factor,
        }
    }
}

/// Load on the wall at one point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Load {
    /// Of weight and tension.
    pub(super) q_N_per_m: Vector3<f64>,
    /// Its magnitude and the part of a helix.
    pub(super) side_force_N_per_m: f64,
    pub(super) axial_friction_N_per_m: f64,
    pub(super) friction_torque_N_m_per_m: f64,
}

/// The hole at one depth.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) tangent: Vector3<f64>,
    pub(super) curvature_per_m: Vector3<f64>,
    pub(super) md_m: f64,
    pub(super) tvd_m: f64,
}

impl Point {
    pub(super) fn new(heading: Heading, [md_m, tvd_m]: [f64; 2]) -> Self {
        let Heading { tangent, curvature_per_m } = heading;
        Self { tangent, curvature_per_m, md_m, tvd_m }
    }
}
