//! A controller of the top drive of one's own: proportional and integral on a speed that gives way
//! to the string's torque.
//!
//! `cargo run -p wholestring --example top_drive_controller`

mod common;

use std::{error::Error, sync::Arc};

use wholestring::{
    dynamics::{CustomTopDrive, TopDriveController, TopDriveReading, TopDriveSettings},
    prelude::*,
};

/// `T = K_p (Ω_set − Ω − (T_s − T_slow)/Z) + I`, `İ = K_i (Ω_set − Ω)`, with `T_slow` the string's
/// torque through a filter.
#[derive(Debug)]
struct GivingWay {
    proportional_N_m_s: f64,
    integral_N_m: f64,
    impedance_N_m_s: f64,
    filter_s: f64,
}

impl TopDriveController for GivingWay {
    fn name(&self) -> &str {
        "giving way"
    }

    /// The integral part and the filtered torque of the string, N·m.
    fn initial_state(&self, torque_N_m: f64) -> Vec<f64> {
        vec![torque_N_m, torque_N_m]
    }

    fn torque_N_m(&self, state: &mut [f64], reading: &TopDriveReading) -> f64 {
        let missing = reading.set_rad_per_s - reading.speed_rad_per_s;
        let heard = reading.string_torque_N_m - state[1];
        let torque = state[0] + self.proportional_N_m_s * (missing - heard / self.impedance_N_m_s);
        if torque.abs() < reading.torque_limit_N_m {
            state[0] += self.integral_N_m * missing * reading.dt_s;
        }
        state[1] += heard * reading.dt_s / (self.filter_s + reading.dt_s);
        torque
    }
}

pub fn main() -> Result<(), Box<dyn Error>> {
    let controller = GivingWay {
        proportional_N_m_s: 30e3,
        integral_N_m: 60e3,
        impedance_N_m_s: 400.0,
        filter_s: 2.0,
    };
    let settings = DynamicsSettings {
        top_drive: TopDriveSettings::Custom(CustomTopDrive {
            inertia_kg_m2: 2000.0,
            controller: Arc::new(controller),
            torque_limit_N_m: Some(45e3),
        }),
        ..common::settings()
    };
    let mut simulation = Simulation::new(&common::model()?, &common::drill(), &settings)?;
    let torque_N_m = simulation.to_end()?.scalars.surface_torque_N_m;
    let speeds = &simulation.series().rotary_speed_rad_per_s;
    let last = speeds[speeds.len() - 1];
    println!("surface torque {torque_N_m:.0} N·m, speed at the end {last:.3} rad/s of 12 set");
    assert!((last - 12.0).abs() < 0.5, "{last}");
    Ok(())
}
