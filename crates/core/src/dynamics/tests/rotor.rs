//! A spinning shaft with the rotary inertia that it has, forwards and backwards.

use wholestring_verification::verify;

use super::{
    bench::{Bench, Support},
    large::section,
};
use crate::{common::verification, dynamics::kernel::chain::node, simd::vector::Vector};

/// Angular frequency at which D09's shaft, spinning at `spin`, whirls in its mode `mode` when it is
/// started at `whirl`, rad/s.
fn whirling(spin: f64, mode: usize, whirl: f64, parts: usize) -> f64 {
    let data = verification("D09_linear_frequencies.json");
    let inputs = &data["spinning_rayleigh_shaft"]["inputs"];
    let [r, length, e, rho] =
        ["r", "L", "E", "rho"].map(|key| inputs[key].as_f64().expect("a number"));
    let area = std::f64::consts::PI * r * r;
    let inertia = 0.25 * area * r * r;
    let section = section(
        [e * area, 1e30, e * inertia, 0.4 * e * 2.0 * inertia],
        rho * area,
        2.0 * rho * inertia,
    );
    let mut rod = Bench::of_section(&section, rho * inertia, length, parts);
    rod.support(0, Support::PINNED);
    rod.support(parts, Support::ROLLER);
    let k = mode as f64 * std::f64::consts::PI / length;
    // The deflection goes round in a circle; velocities are half a step behind.
    let size = 1e-6;
    let (sine, cosine) = (0.5 * whirl * rod.input.dt).sin_cos();
    for i in 0..=parts {
        let z = rod.z_m(i);
        let (shape, slope) = (size * (k * z).sin(), size * k * (k * z).cos());
        let round = Vector(sine, cosine, 0.0).scaled(whirl);
        node!(rod.chain, i, spin = spin);
        rod.chain.set_director(i, Vector(slope, 0.0, (1.0 - slope * slope).sqrt()));
        let ends = i == 0 || i == parts;
        if !ends {
            rod.chain.set_displacement(i, Vector(shape, 0.0, 0.0));
            rod.chain.set_velocity(i, round.scaled(shape));
        }
        rod.chain.set_turning(i, Vector(-round.1 * slope, round.0 * slope, 0.0));
    }
    std::f64::consts::TAU
        * rod.frequency_Hz(5, |rod| {
            (0..=parts).map(|i| (k * rod.z_m(i)).sin() * rod.chain.displacement(i).0).sum()
        })
}

/// D09: two modes at three speeds, forwards and backwards, no mass scaling. The source requires 0.1
/// %; 30 elements are within 2e-6 and 60 within 3e-7, fourth order until the step shows. The split
/// of the two directions is within 1e-3 of itself, which is 1e-6 to 1e-5 of the frequencies.
#[test]
fn a_spinning_shaft_whirls_at_its_frequencies() {
    let data = verification("D09_linear_frequencies.json");
    for case in data["spinning_rayleigh_shaft"]["cases"].as_array().expect("cases") {
        let number = |key: &str| case[key].as_f64().expect("a number");
        let (spin, mode) = (number("Omega_rad_s"), number("mode") as usize);
        let exact = ["forward_rad_s", "backward_rad_s"].map(number);
        let found = exact.map(|whirl| [30, 60].map(|parts| whirling(spin, mode, whirl, parts)));
        for (i, direction) in ["forward", "backward"].into_iter().enumerate() {
            for (parts, computed, within) in [(30, found[i][0], 5e-6), (60, found[i][1], 1e-6)] {
                verify(
                    "D09",
                    format!(
                        "spinning shaft at {spin:.1} rad/s: {direction} mode {mode} with {parts} \
                        elements, rad/s"
                    ),
                )
                .relative(within, "three times mesh and step error; the source requires 0.1 %")
                .report(exact[i].abs(), computed);
            }
        }
        let split = exact[0] + exact[1];
        if split > 0.0 {
            verify(
                "D09",
                format!("spinning shaft at {spin:.1} rad/s: split of mode {mode}, rad/s"),
            )
            .relative(
                1e-3,
                "errors of 60 elements, 3e-7, over the part of the frequency that is split",
            )
            .report(split, found[0][1] - found[1][1]);
        }
    }
}
