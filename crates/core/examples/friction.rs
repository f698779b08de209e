//! Friction of one's own along the hole: a bed of cuttings where the hole is inclined.
//!
//! Coefficients along the hole, at rest and sliding, along and around, which every solver knows.
//! One that depends on speed or force is in the example `friction_law`.
//!
//! `cargo run -p wholestring --example friction`

mod common;

use std::error::Error;

use wholestring::prelude::*;

pub fn main() -> Result<(), Box<dyn Error>> {
    let clean = common::model()?;
    let mut bedded = clean.clone();
    // Cuttings lie between 40° and 60°; a string that slides ploughs them, one that turns rolls
    // over them.
    bedded.well.hole = clean.well.hole.with_friction_profile(10.0, |md_m| {
        let here = clean.well.hole.at(md_m).friction;
        let inclination_deg = clean.well.path.at(md_m).inclination_rad().to_degrees();
        if (40.0..=60.5).contains(&inclination_deg) {
            Friction {
                kinetic: here.kinetic + 0.15,
                at_rest: here.at_rest + 0.20,
                around: here.kinetic / (here.kinetic + 0.15),
            }
        } else {
            here
        }
    })?;
    let pull = Operation::trip_out(common::BIT_DEPTH_M);
    let turn = Operation::rotate_off_bottom(common::BIT_DEPTH_M).rotary_speed_rad_per_s(12.0);
    let [clean_pull, bedded_pull] = [
        soft_string(&clean, &pull)?.scalars.hook_load_N,
        soft_string(&bedded, &pull)?.scalars.hook_load_N,
    ];
    let [clean_turn, bedded_turn] = [
        soft_string(&clean, &turn)?.scalars.surface_torque_N_m,
        soft_string(&bedded, &turn)?.scalars.surface_torque_N_m,
    ];
    println!("hook load pulling out: {clean_pull:.0} N clean, {bedded_pull:.0} N on cuttings");
    println!("torque off bottom: {clean_turn:.0} N·m clean, {bedded_turn:.0} N·m on cuttings");
    assert!(bedded_pull > 1.05 * clean_pull);
    assert!((bedded_turn / clean_turn - 1.0).abs() < 1e-6);
    Ok(())
}
