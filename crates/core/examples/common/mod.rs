//! The well and the string that the examples share.

use std::error::Error;

use wholestring::prelude::*;

/// Depth of the bit, m.
pub const BIT_DEPTH_M: f64 = 1500.0;

/// A well that builds to 60° between 300 m and 900 m, and a string that reaches its end.
pub fn model() -> Result<Model, Box<dyn Error>> {
    let path = Path::spline(&[
        Station::from_degrees(0.0, 0.0, 45.0),
        Station::from_degrees(300.0, 0.0, 45.0),
        Station::from_degrees(900.0, 60.0, 45.0),
        Station::from_degrees(BIT_DEPTH_M, 60.0, 45.0),
    ])?;
    let hole = Hole::new(vec![
        HoleSection::casing(0.0..800.0, 0.2224, 0.25),
        HoleSection::open(800.0..BIT_DEPTH_M, 0.2159, 0.30),
    ])?;
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
        .catalogue("6-1/2 in x 2-13/16 in collar", Metres(60.0))?
        .catalogue("5 in 19.50 lb/ft S-135", ToSurface)?
        .assemble(BIT_DEPTH_M)?;
    Ok(Model::new(Well::new(path, hole), string, Mud::of_density(1200.0)))
}

/// Rotary drilling at 115 rev/min with 50 kN on the bit.
#[allow(dead_code, reason = "every example uses its own part of this module")]
pub fn drill() -> Operation {
    Operation::drill(BIT_DEPTH_M)
        .rotary_speed_rad_per_s(12.0)
        .weight_on_bit_N(50e3)
        .bit_torque_N_m(3e3)
        .rate_of_penetration_m_per_s(5e-3)
}

/// A short window after the start has settled: enough to see what an example shows.
#[allow(dead_code, reason = "every example uses its own part of this module")]
pub fn settings() -> wholestring::dynamics::DynamicsSettings {
    DynamicsSettings { settle_s: 6.0, duration_s: 4.0, ..DynamicsSettings::default() }
}
