//! An excitation of one's own: cusps on bottom under a bit that cuts by Detournay and Defourny's
//! law.
//!
//! `cargo run -p wholestring --example excitation`

mod common;

use std::error::Error;

use wholestring::{
    dynamics::{
        BitExcitation, BitLaw, BitSettings, CustomExcitation, Cutters, DetournayDefournyLaw, Shake,
    },
    prelude::*,
};

/// A bottom with cusps: `A |sin(m φ/2)|`, `m` of them per revolution.
#[derive(Debug)]
struct Cusps {
    amplitude_m: f64,
    per_revolution: f64,
}

impl BitExcitation for Cusps {
    fn name(&self) -> &str {
        "cusps"
    }

    fn shake(&self, _state: &[f64], bit_angle_rad: f64, _time_s: f64) -> Shake {
        Shake {
            front_m: self.amplitude_m * (0.5 * self.per_revolution * bit_angle_rad).sin().abs(),
            torque: 0.0,
        }
    }
}

/// Standard deviation of the weight on bit, N, on a smooth bottom or on cusps.
fn weight_std_N(cusps: Option<Cusps>) -> Result<f64, Box<dyn Error>> {
    let law = DetournayDefournyLaw {
        cutters: Cutters {
            radius_m: 0.108,
            core_radius_m: 0.0,
            intrinsic_specific_energy_Pa: 60e6,
            cutter_inclination: 0.6,
            wear_flat_m: 1.2e-3,
            contact_strength_Pa: 60e6,
            bit_geometry: 1.0,
            friction: 0.6,
        },
        full_contact_depth_m: 0.5e-3,
        cleaning_limit_m: None,
        rock_stiffness_N_per_m: 1e8,
        excitation: None,
    };
    let bit = BitSettings {
        law: BitLaw::DetournayDefourny(law),
        excitation: cusps.map(CustomExcitation::new),
        ..BitSettings::default()
    };
    let drill = bit.drilling_steadily(common::drill());
    let settings = DynamicsSettings { bit, ..common::settings() };
    let outcome = Simulation::new(&common::model()?, &drill, &settings)?.to_end()?;
    Ok(outcome.statistic("weight_on_bit_N").map_or(0.0, |weight| weight.std))
}

pub fn main() -> Result<(), Box<dyn Error>> {
    let smooth = weight_std_N(None)?;
    let cusps = weight_std_N(Some(Cusps { amplitude_m: 0.5e-3, per_revolution: 3.0 }))?;
    println!("standard deviation of the weight on bit: {smooth:.0} N, on cusps {cusps:.0} N");
    assert!(cusps > 2.0 * smooth, "{smooth} {cusps}");
    Ok(())
}
