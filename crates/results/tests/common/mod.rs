//! Shared parts of the tests of frames.
#![allow(unreachable_pub)]

use wholestring::dynamics::Frame;

/// Nodes of a string of 4300 m.
pub const NODES: usize = 1350;

/// A frame in which every number can be distinguished from every other.
pub fn frame(time_s: f64) -> Frame {
    let mut next = time_s;
    let mut column = || {
        next += 1.0;
        let from = next;
        (0..NODES).map(move |node| 1e3 * (from + 0.37 * node as f64).sin()).collect::<Vec<f64>>()
    };
    Frame {
        time_s,
        md_m: (0..NODES).map(|node| 3.2 * node as f64).collect(),
        offset_high_m: column(),
        offset_right_m: column(),
        north_m: column(),
        east_m: column(),
        tvd_m: column(),
        velocity_high_m_per_s: column(),
        velocity_right_m_per_s: column(),
        axial_velocity_m_per_s: column(),
        rotary_speed_rad_per_s: column(),
        twist_rad: column(),
        tilt_high_rad: column(),
        tilt_right_rad: column(),
        contact_force_N: column(),
        axial_friction_N: column(),
        friction_torque_N_m: column(),
        tension_N: column(),
        torque_N_m: column(),
        bending_moment_N_m: column(),
        von_mises_stress_Pa: column(),
    }
}
