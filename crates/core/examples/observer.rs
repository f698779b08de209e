//! An observer of samples: it watches for the highest surface torque and ends the run when the
//! string has turned twenty times.
//!
//! `cargo run -p wholestring --example observer`

mod common;

use std::{error::Error, f64::consts::TAU, ops::ControlFlow};

use wholestring::{dynamics::Observer, prelude::*};

/// The largest surface torque so far, and how often the top has turned.
#[derive(Debug, Default)]
struct TorqueWatch {
    largest_N_m: f64,
    at_s: f64,
    revolutions: f64,
}

impl Observer for TorqueWatch {
    fn sampled(&mut self, simulation: &Simulation) -> ControlFlow<()> {
        let series = simulation.series();
        if let (Some(torque_N_m), Some(speed_rad_per_s)) =
            (series.surface_torque_N_m.last(), series.rotary_speed_rad_per_s.last())
        {
            if *torque_N_m > self.largest_N_m {
                (self.largest_N_m, self.at_s) = (*torque_N_m, simulation.time_s());
            }
            self.revolutions += speed_rad_per_s * simulation.sample_interval_s() / TAU;
        }
        if self.revolutions < 20.0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }
}

pub fn main() -> Result<(), Box<dyn Error>> {
    let mut watch = TorqueWatch::default();
    let settings = DynamicsSettings { duration_s: 20.0, ..common::settings() };
    let mut simulation = Simulation::new(&common::model()?, &common::drill(), &settings)?;
    simulation.to_end_with(&mut watch)?;
    println!(
        "after {:.2} s: at most {:.0} N·m, at {:.2} s",
        simulation.time_s(),
        watch.largest_N_m,
        watch.at_s
    );
    // Twenty turns at 12 rad/s take 10.5 s; the window would have ended at 26 s.
    assert!((simulation.time_s() - 20.0 * TAU / 12.0).abs() < 0.1);
    Ok(())
}
