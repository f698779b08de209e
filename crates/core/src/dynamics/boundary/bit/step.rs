//! State of the bit's node at the beginning of a step, and the results of the step.

use super::excitation::Shake;
use crate::simd::vector::Vector;

/// State of the bit's node at the beginning of a step.
#[derive(Debug, Clone, Copy)]
pub struct StepStart {
    /// Its velocity, m/s.
    pub velocity: Vector<f64>,
    /// Its spin, rad/s.
    pub spin: f64,
}

/// The bit's node as the step left it, without the rock.
#[derive(Debug, Clone, Copy)]
pub(super) struct Approach {
    /// Measured depth of the bit, m.
    pub(super) depth_m: f64,
    /// Its velocity along the hole, m/s, positive downwards.
    pub(super) velocity_m_per_s: f64,
    /// Velocity per axial force, s/kg.
    pub(super) axial_mobility_s_per_kg: f64,
    /// Spin of the string before the step, rad/s.
    pub(super) spin_before_rad_per_s: f64,
    /// Spin that the step gave it, rad/s.
    pub(super) spin_rad_per_s: f64,
    /// Spin per torque, 1/(N·m·s).
    pub(super) turning_mobility: f64,
    /// Excitation of the rock front in addition to the law.
    pub(super) shake: Shake,
    /// Step, s.
    pub(super) dt: f64,
}

/// Reaction of the rock.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RockReaction {
    pub(super) weight_N: f64,
    /// Against the string's rotation.
    pub(super) torque_N_m: f64,
    /// Spin that the torque leaves the string, exactly zero of a bit without motor that it holds.
    pub(super) spin_rad_per_s: f64,
    pub(super) depth_of_cut_m: f64,
    /// Rock that is taken away per time, m/s.
    pub(super) rate_m_per_s: f64,
}

/// Results of a step for the bit.
#[derive(Debug, Clone, Copy)]
pub struct BitStep {
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Torque on bit, N·m.
    pub torque_N_m: f64,
    /// Rock that a revolution takes away, m.
    pub depth_of_cut_m: f64,
    /// Rock that is taken away per time, m/s.
    pub rate_of_penetration_m_per_s: f64,
    /// Force of rock and hole on the bit, N.
    pub force_N: Vector<f64>,
    /// Bending moment of the rock on the bit, N·m.
    pub moment_N_m: f64,
    /// Speed of the motor against the string, rad/s.
    pub motor_speed_rad_per_s: f64,
    /// Work done on the string, J.
    pub work_J: f64,
}

impl Default for BitStep {
    fn default() -> Self {
        Self {
            weight_on_bit_N: 0.0,
            torque_N_m: 0.0,
            depth_of_cut_m: 0.0,
            rate_of_penetration_m_per_s: 0.0,
            force_N: Vector::zero(),
            moment_N_m: 0.0,
            motor_speed_rad_per_s: 0.0,
            work_J: 0.0,
        }
    }
}

/// Results of a step for bit and rock, as passed to a user-defined law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BitRockStep {
    /// Length of the step, s.
    pub dt_s: f64,
    /// Weight on bit at its end, N.
    pub weight_on_bit_N: f64,
    /// Torque on bit, N·m.
    pub torque_N_m: f64,
    /// Speed of the bit, motor included, rad/s.
    pub bit_speed_rad_per_s: f64,
    /// Advance of the rock front, m.
    pub advance_m: f64,
}
