//! A friction law of one's own: a coefficient that falls with the sliding speed by Stribeck's
//! curve.
//!
//! `cargo run -p wholestring --example friction_law`

mod common;

use std::error::Error;

use wholestring::{
    dynamics::{CustomFriction, FrictionCoefficient, SlidingContact},
    prelude::*,
};

/// `μ = μ_k (1 + rise exp(−v/v_s))`, with the kinetic coefficient of the hole section.
#[derive(Debug)]
struct Stribeck {
    rise: f64,
    speed_m_per_s: f64,
}

impl FrictionCoefficient for Stribeck {
    fn name(&self) -> &str {
        "Stribeck"
    }

    fn coefficient(&self, _state: &mut [f64], contact: &SlidingContact) -> f64 {
        let decay = (-contact.sliding_speed_m_per_s() / self.speed_m_per_s).exp();
        contact.friction.kinetic * (1.0 + self.rise * decay)
    }
}

/// Torque that friction takes of a string that turns off bottom, N·m.
fn friction_torque_N_m(
    rotary_speed_rad_per_s: f64,
    law: Option<CustomFriction>,
) -> Result<f64, Box<dyn Error>> {
    let turn = Operation::rotate_off_bottom(common::BIT_DEPTH_M)
        .rotary_speed_rad_per_s(rotary_speed_rad_per_s);
    let settings = DynamicsSettings { friction_coefficient: law, ..common::settings() };
    let outcome = Simulation::new(&common::model()?, &turn, &settings)?.to_end()?;
    Ok(outcome.scalars.friction_torque_N_m)
}

pub fn main() -> Result<(), Box<dyn Error>> {
    let law = CustomFriction::new(Stribeck { rise: 0.5, speed_m_per_s: 0.5 });
    for rotary_speed_rad_per_s in [6.0, 12.0] {
        let plain = friction_torque_N_m(rotary_speed_rad_per_s, None)?;
        let own = friction_torque_N_m(rotary_speed_rad_per_s, Some(law.clone()))?;
        println!(
            "friction torque at {rotary_speed_rad_per_s} rad/s: {plain:.0} N·m, {own:.0} N·m by the law"
        );
        // Joints of 84 mm and collars of 83 mm radius carry the string. With more friction it
        // climbs the wall a little more, which takes up to 2 % off its contact force.
        let sliding_m_per_s = 0.083 * rotary_speed_rad_per_s;
        let expected = 1.0 + 0.5 * (-sliding_m_per_s / 0.5).exp();
        assert!((own / plain / expected - 1.0).abs() < 0.03, "{own} {plain} {expected}");
    }
    Ok(())
}
