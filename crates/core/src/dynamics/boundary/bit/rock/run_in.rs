//! A bit that has drilled before the string has it.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::{RockLaw, RunIn};
use crate::{
    GRAVITY_M_PER_S2,
    dynamics::{
        assemble::SetupError,
        boundary::{
            bit::{law::BitLaw, motor::Drive, settings::BitSettings},
            executor::RockExecutor,
        },
    },
    operation::Operation,
    rock::{Advance, BitMotion, Drilling, Driver, Executor, Inertia},
};

/// Revolutions on its bottom before the start: one in which each blade reaches the surface that it
/// has left itself and the first elements erode, and one that is typical.
const REVOLUTIONS: usize = 2;

/// For a bit that does not turn before the start: duration of the increase of the weight, s,
/// maximum duration of pressing, s, and damping, 1/s.
const GROWING_S: f64 = 0.015;
const PRESSING_S: f64 = 0.3;
const PRESSING_DAMPING_PER_S: f64 = 2000.0;

/// The bit is at rest once the rock supports the weight to this fraction.
const RESTS: f64 = 0.01;

/// A bit that turns more slowly, rad/s, is pressed alone: its two revolutions would take longer
/// than most runs.
const SLOWEST_RAD_PER_S: f64 = 1.0;

/// Step before the start, s.
const STEP_S: f64 = 2e-4;

/// State of a bit on its rock at time zero.
#[derive(Debug, Clone, Copy)]
pub struct Standing {
    /// Weight on it, N.
    pub weight_N: f64,
    /// Rate of penetration, m/s.
    pub rate_m_per_s: f64,
    /// Speed of the string, rad/s.
    pub string_rad_per_s: f64,
    /// Mass that moves along the hole with it, kg.
    pub mass_kg: f64,
}

impl RunIn {
    /// Runs the bit in; none where no solid rock is drilled. A motor turns it as fast as under the
    /// torque that `first` expects.
    ///
    /// # Errors
    /// A bit or a block of rock that is invalid, and an executor that requests a stop.
    pub fn new(
        settings: &BitSettings,
        first: &Operation,
        standing: Standing,
        executor: &RockExecutor,
    ) -> Result<Option<Self>, SetupError> {
        let BitLaw::Rock(law) = &settings.law else {
            return Ok(None);
        };
        let mut run_in = Self {
            drilling: Drilling::new(&law.drilling)?,
            weight_N: standing.weight_N,
            torque_N_m: 0.0,
            depth_of_cut_m: 0.0,
        };
        if standing.weight_N > 0.0 {
            let flow = first.flow_now_m3_per_s();
            let motor = Drive::new(settings.motor, flow, first.bit_torque_now_N_m());
            let turning_rad_per_s = standing.string_rad_per_s + motor.speed_rad_per_s();
            if turning_rad_per_s >= SLOWEST_RAD_PER_S {
                let last = turn(&mut run_in.drilling, standing, turning_rad_per_s, executor)?;
                run_in.torque_N_m = (-last.moment_N_m.z).min(settings.motor.max_torque_N_m());
                run_in.depth_of_cut_m = standing.rate_m_per_s * TAU / turning_rad_per_s;
            } else {
                press(&mut run_in.drilling, standing, executor)?;
            }
        }
        Ok(Some(run_in))
    }
}

impl RockLaw {
    /// Maximum duration of running in a bit at this speed before the first step of a run, s.
    pub fn run_in_s(turning_rad_per_s: f64) -> f64 {
        if turning_rad_per_s >= SLOWEST_RAD_PER_S {
            REVOLUTIONS as f64 * TAU / turning_rad_per_s
        } else {
            PRESSING_S
        }
    }
}

/// Drills under the weight at a constant speed and returns the means over the last revolution. The
/// mass that moves down with the bit is that of the weight, or of the bit's node if that is
/// greater.
fn turn(
    drilling: &mut Drilling,
    standing: Standing,
    rotary_rad_per_s: f64,
    executor: &RockExecutor,
) -> Result<Advance, SetupError> {
    let driver = Driver::Weight {
        weight_N: standing.weight_N,
        mass_kg: standing.mass_kg.max(standing.weight_N / GRAVITY_M_PER_S2),
        rotary_rad_per_s,
    };
    let mut pose = *drilling.pose();
    pose.velocity_m_per_s = Vector3::z() * standing.rate_m_per_s;
    drilling.place(pose);
    let turn_s = TAU / rotary_rad_per_s;
    let steps = (turn_s / STEP_S).ceil();
    let mut last = Advance::default();
    for _ in 0..REVOLUTIONS {
        last = Advance::default();
        for _ in 0..steps as usize {
            check_running(executor)?;
            last.join(&driver.drive(drilling, turn_s / steps, &executor.stepper, &executor.shared));
        }
    }
    Ok(last)
}

/// Returns an error where the executor requests a stop.
fn check_running(executor: &RockExecutor) -> Result<(), SetupError> {
    if executor.shared.stopped() {
        return Err(SetupError::Stopped);
    }
    Ok(())
}

/// Lets a bit that only moves along the hole sink until the rock supports its weight.
fn press(
    drilling: &mut Drilling,
    standing: Standing,
    executor: &RockExecutor,
) -> Result<(), SetupError> {
    // Decay of a dashpot alone over a step, exact.
    let left = libm::exp(-PRESSING_DAMPING_PER_S * STEP_S);
    for step in 1..=(PRESSING_S / STEP_S) as usize {
        check_running(executor)?;
        let weight_N = standing.weight_N * (step as f64 * STEP_S / GROWING_S).min(1.0);
        let motion = BitMotion {
            velocity_m_per_s: Vector3::z() * (left * drilling.pose().velocity_m_per_s.z),
            angular_velocity_rad_per_s: Vector3::zeros(),
            force_N: Vector3::z() * weight_N,
            moment_N_m: Vector3::zeros(),
            inertia: Inertia { mass_kg: standing.mass_kg, ..Inertia::PRESCRIBED },
        };
        let advance = drilling.advance(STEP_S, &motion, &executor.stepper, &executor.shared);
        if (-advance.force_N.z / standing.weight_N - 1.0).abs() < RESTS {
            break;
        }
    }
    Ok(())
}
