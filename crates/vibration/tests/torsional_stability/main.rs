//! Torsional stability against closed forms, eigenvalues, and the dynamics.

#[path = "../../../core/tests/common/mod.rs"]
mod common;

mod delay;
mod dynamics;
mod eigenvalues;
mod pendulum;
mod uniform;

use wholestring_vibration::torsional_stability::{
    Band, LinearBit, LinearDrive, LinearHoist, LinearRock, LumpedChain, Root, Stability,
    SteadyRotation,
};

/// A bit that only turns, with the torque that it gains per speed.
const fn turning(torque_per_speed_N_m_s: f64) -> LinearBit {
    LinearBit {
        rock: LinearRock::Bears,
        torque_per_weight_m: 0.0,
        torque_per_speed_N_m_s,
        advance_per_angle_m: 0.0,
        motor_droop_rad_per_s_per_N_m: 0.0,
        torque_N_m: 0.0,
        rate_m_per_s: 0.0,
    }
}

/// An axial chain of a mass that nothing but a constant force holds.
fn hung(mass_kg: f64) -> LumpedChain {
    LumpedChain {
        inertia: vec![1e-9 * mass_kg, mass_kg],
        stiffness: vec![1.0],
        drag: vec![0.0; 2],
        stiffness_damping_s: 0.0,
    }
}

/// A string in torsion alone.
fn in_torsion(torsion: LumpedChain, drive: LinearDrive, bit: LinearBit) -> SteadyRotation {
    SteadyRotation { torsion, axial: hung(1.0), drive, hoist: LinearHoist::Force(0.0), bit }
}

fn worst(stability: &Stability) -> Root {
    assert!(stability.complete, "{stability:?}");
    stability.worst.expect("a root")
}

const fn band(lowest_rad_per_s: f64, highest_rad_per_s: f64) -> Band {
    Band { lowest_rad_per_s, highest_rad_per_s }
}
