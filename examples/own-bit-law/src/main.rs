//! `own-bit-law CASE.toml`: drills a case with a user-defined law at two rotary speeds.

use std::{env, error::Error, path::Path};

use own_bit_law::{FallingTorque, case, drill};

fn main() -> Result<(), Box<dyn Error>> {
    let file = env::args().nth(1).ok_or("usage: own-bit-law CASE.toml")?;
    let law = FallingTorque {
        depth_of_cut_per_weight_m_per_N: 2e-8,
        torque_per_weight_m: 0.05,
        rise: 1.0,
        half_rad_per_s: 6.0,
    };
    for rpm in [60, 150] {
        let changes = ["model=dynamic", "operation.kind=drill", &format!("rpm={rpm}")];
        let changes: Result<Vec<_>, _> = changes.iter().map(|change| change.parse()).collect();
        let [slowest, fastest, torque_N_m] = drill(&case(Path::new(&file), law, &changes?)?)?;
        println!(
            "{rpm} rev/min: the bit turns with {slowest:.1} to {fastest:.1} rad/s, {:.2} kN.m",
            torque_N_m / 1e3
        );
    }
    Ok(())
}
