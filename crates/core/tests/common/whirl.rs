//! Whether a string that turns goes round its hole for ever, by the dynamics.

use std::f64::consts::{PI, TAU};

use wholestring::{
    dynamics::{Frame, RodDamping},
    prelude::*,
};

/// Time between two looks, s: in it no node goes half way round.
const LOOK_S: f64 = 0.1;

/// A node that is nearer to the hole's axis is on no side of it, m.
const OFF_M: f64 = 5e-3;

/// Damping by mass that brings a string to rest which has a state of rest, 1/s.
const DAMPING_PER_S: f64 = 0.5;

/// A slow turn, rad/s; the string moves along the hole the slower by as much.
const TURN_RAD_PER_S: f64 = 2.0;

/// Greatest rotation of a node round its hole against the string's rotation within a window, after
/// so long a time, both in s: in whole turns. A rolling node moves backwards; a bent motor moves
/// its neighbours round with it, forwards. None where the simulation has no result.
pub fn turns(model: &Model, operation: &Operation, [settle_s, window_s]: [f64; 2]) -> Option<f64> {
    let slower = TURN_RAD_PER_S / operation.rotary_speed_rad_per_s;
    let operation = Operation {
        rotary_speed_rad_per_s: TURN_RAD_PER_S,
        trip_speed_m_per_s: slower * operation.trip_speed_m_per_s,
        rate_of_penetration_m_per_s: slower * operation.rate_of_penetration_m_per_s,
        ..*operation
    };
    let own = DynamicsSettings::default();
    let settings = DynamicsSettings {
        settle_s,
        duration_s: window_s,
        damping: RodDamping { mass_per_s: DAMPING_PER_S, ..own.damping },
        ..own
    };
    let mut simulation = Simulation::new(model, &operation, &settings).ok()?;
    simulation.advance(settle_s).ok()?;
    let mut last = angles_rad(&simulation.frame());
    let mut round_rad = vec![0.0; last.len()];
    for _ in 0..(window_s / LOOK_S) as usize {
        simulation.advance(LOOK_S).ok()?;
        let now = angles_rad(&simulation.frame());
        for ((round, now), last) in round_rad.iter_mut().zip(&now).zip(&last) {
            *round += (now - last + PI).rem_euclid(TAU) - PI;
        }
        last = now;
    }
    Some(round_rad.iter().fold(0.0_f64, |most, round| most.max(-round)) / TAU)
}

/// In which direction from the hole's axis each node is; the same for those that are hardly off it.
fn angles_rad(frame: &Frame) -> Vec<f64> {
    let offsets = frame.offset_high_m.iter().zip(&frame.offset_right_m);
    let angle = |(high_m, right_m): (&f64, &f64)| {
        if high_m.hypot(*right_m) > OFF_M { right_m.atan2(*high_m) } else { 0.0 }
    };
    offsets.map(angle).collect()
}
