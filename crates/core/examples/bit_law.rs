//! A law of the bit of one's own: a bit that blunts with the work that it has done.
//!
//! `cargo run -p wholestring --example bit_law`

mod common;

use std::{error::Error, f64::consts::TAU};

use wholestring::{
    dynamics::{BitLaw, BitRockLaw, BitRockStep, BitSettings, CustomLaw, SteadyCut},
    prelude::*,
};

/// Depth of cut and torque in proportion to weight; the depth of cut falls to half by the time that
/// the bit has done a given work.
#[derive(Debug)]
struct BluntingBit {
    depth_of_cut_per_weight_m_per_N: f64,
    torque_per_weight_m: f64,
    half_life_J: f64,
}

impl BitRockLaw for BluntingBit {
    fn name(&self) -> &str {
        "blunting bit"
    }

    /// The work done so far, J.
    fn initial_state(&self) -> Vec<f64> {
        vec![0.0]
    }

    fn cut(&self, state: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let sharpness = 1.0 / (1.0 + state[0] / self.half_life_J);
        let depth_of_cut_m = sharpness * self.depth_of_cut_per_weight_m_per_N * weight_on_bit_N;
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: self.torque_per_weight_m * weight_on_bit_N,
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }

    fn advance(&self, state: &mut [f64], step: &BitRockStep) {
        state[0] += step.torque_N_m * step.bit_speed_rad_per_s * step.dt_s;
    }
}

pub fn main() -> Result<(), Box<dyn Error>> {
    let model = common::model()?;
    let law = BluntingBit {
        depth_of_cut_per_weight_m_per_N: 5e-8,
        torque_per_weight_m: 0.06,
        half_life_J: 300e3,
    };
    let bit =
        BitSettings { law: BitLaw::Custom(CustomLaw::new(law, 1e8)), ..BitSettings::default() };
    // The operation with the torque and the rate that a new bit has.
    let drill = bit.drilling_steadily(common::drill());
    let settings = DynamicsSettings { bit, ..common::settings() };
    let mut simulation = Simulation::new(&model, &drill, &settings)?;
    simulation.to_end()?;
    let rates = &simulation.series().rate_of_penetration_m_per_s;
    let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    let (first, last) = (mean(&rates[..100]), mean(&rates[rates.len() - 100..]));
    println!(
        "rate of penetration: {:.1} m/h in the first second, {:.1} m/h in the last",
        first * 3600.0,
        last * 3600.0
    );
    // 3 kN·m at 12 rad/s do 360 kJ in 10 s: the bit is blunt by more than half.
    assert!(last < 0.6 * first, "{first} {last}");
    Ok(())
}
