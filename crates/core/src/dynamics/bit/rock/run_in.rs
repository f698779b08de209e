//! A bit that has drilled before the string has it.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::RockCut;
use crate::{
    GRAVITY_M_PER_S2,
    dynamics::{
        bit::{BitLaw, BitSettings, motor::Drive},
        crew::Crew,
    },
    operation::Operation,
    rock::{Advance, BitMotion, Drilling, DrillingError, Driver, Inertia},
};

/// Revolutions on its bottom before the start: one in which each blade meets what it has left itself and the bricks begin to go, and
/// one that is typical.
const REVOLUTIONS: usize = 2;

/// How long a bit that does not turn presses before the start, s, when all weight is there, as a part of that, and what calms
/// it, 1/s.
const PRESSING_S: f64 = 0.03;
const PRESSED: f64 = 0.5;
const PRESSING_DAMPING_PER_S: f64 = 2000.0;

/// Step before the start, s.
const STEP_S: f64 = 2e-4;

/// How a bit stands on its rock at time zero.
#[derive(Debug, Clone, Copy)]
pub struct Standing {
    /// Weight on it, N.
    pub weight_N: f64,
    /// How fast it goes down, m/s.
    pub rate_m_per_s: f64,
    /// Mass that moves along the hole with it, kg.
    pub mass_kg: f64,
}

/// A bit on its bottom, run in as the string moves at time zero.
#[derive(Debug, Clone)]
pub struct RunIn {
    cut: RockCut,
    torque_N_m: f64,
}

impl RunIn {
    /// Runs the bit in; none where no solid rock is drilled.
    ///
    /// # Errors
    /// A bit or a block of rock that cannot be.
    pub fn new(
        settings: &BitSettings,
        first: &Operation,
        standing: Standing,
        crew: &Crew,
    ) -> Result<Option<Self>, DrillingError> {
        let BitLaw::Rock(law) = &settings.law else {
            return Ok(None);
        };
        let mut drilling = Drilling::new(&law.drilling)?;
        let expected_N_m = first.bit_torque_now_N_m();
        let motor = Drive::new(settings.motor, first.flow_now_m3_per_s(), expected_N_m);
        let turning_rad_per_s = first.rotation_rad_per_s() + motor.speed_rad_per_s();
        let mut torque_N_m = expected_N_m;
        let mut depth_of_cut_m = 0.0;
        if turning_rad_per_s > 0.0 {
            depth_of_cut_m = standing.rate_m_per_s * TAU / turning_rad_per_s;
            if standing.weight_N > 0.0 {
                let last = turn(&mut drilling, standing, turning_rad_per_s, crew);
                torque_N_m = (-last.moment_N_m.z).min(settings.motor.most_torque_N_m());
            }
        } else if standing.weight_N > 0.0 {
            press(&mut drilling, standing, crew);
        }
        Ok(Some(Self {
            cut: RockCut::new(drilling, standing.weight_N, torque_N_m, depth_of_cut_m),
            torque_N_m,
        }))
    }

    /// Torque that it took in its last revolution, N·m; what was expected where it did not turn.
    pub fn torque_N_m(&self) -> f64 {
        self.torque_N_m
    }

    /// The rock, cut by the bit.
    pub(in crate::dynamics::bit) fn into_cut(self) -> RockCut {
        self.cut
    }
}

/// Drills under the weight at a constant speed; what came of the last revolution. What weighs as much as the weight, or the
/// bit's node if that is more, goes down with the bit.
fn turn(
    drilling: &mut Drilling,
    standing: Standing,
    rotary_rad_per_s: f64,
    crew: &Crew,
) -> Advance {
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
            last.join(&driver.drive(drilling, turn_s / steps, &crew.stepper, &crew.lent));
        }
    }
    last
}

/// Lets a bit that only goes along the hole sink until the rock bears it.
fn press(drilling: &mut Drilling, standing: Standing, crew: &Crew) {
    let steps = (PRESSING_S / STEP_S).ceil();
    let step_s = PRESSING_S / steps;
    let left = (-PRESSING_DAMPING_PER_S * step_s).exp();
    for step in 1..=steps as usize {
        let part = (step as f64 / (PRESSED * steps)).min(1.0);
        let motion = BitMotion {
            velocity_m_per_s: Vector3::z() * (left * drilling.pose().velocity_m_per_s.z),
            angular_velocity_rad_per_s: Vector3::zeros(),
            force_N: Vector3::z() * (part * standing.weight_N),
            moment_N_m: Vector3::zeros(),
            inertia: Inertia {
                mass_kg: standing.mass_kg,
                ..Inertia::TOLD
            },
        };
        drilling.advance(step_s, &motion, &crew.stepper, &crew.lent);
    }
}
