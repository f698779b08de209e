//! Orders of convergence in the element's length and in the step.

use wholestring_verification::verify;

use super::{beams::beam, bench::Support};
use crate::{dynamics::kernel::chain::node, simd::vector::Vector};

/// A pinned pipe struck across in two planes and about its axis, so hard that it swings by a metre:
/// where its middle and its end are after half a second.
fn struck(parts: usize, part: f64) -> [f64; 4] {
    let length = 30.0;
    let mut rod = beam(length, parts);
    // The same step for every mesh, and a whole number of them.
    let steps = (0.5 / (2e-4 * part)).round();
    rod.input.dt = 0.5 / steps;
    rod.support(0, Support::PINNED);
    rod.support(parts, Support { spin: true, ..Support::ROLLER });
    let k = std::f64::consts::PI / length;
    for i in 0..=parts {
        let z = rod.z_m(i);
        let inner = if i == 0 || i == parts { 0.0 } else { 1.0 };
        let (x, y) = (3.0 * (k * z).sin(), 2.0 * (2.0 * k * z).sin());
        let (tilt_x, tilt_y) = (3.0 * k * (k * z).cos(), 4.0 * k * (2.0 * k * z).cos());
        let spin = 10.0 * (0.5 * k * z).sin();
        rod.chain.set_velocity(i, Vector(inner * x, inner * y, 0.0));
        node!(rod.chain, i, spin = spin);
        // Straight and unstrained, nothing accelerates it but its own gyroscopic moment: half a
        // step before, that had yet to turn it.
        let w = Vector(-tilt_y, tilt_x, 0.0);
        let back = 0.5 * rod.input.dt * node!(rod.chain, i, gyroscopic) * spin;
        let turned = w.cross(Vector(0.0, 0.0, 1.0)).scaled(back);
        rod.chain.set_turning(i, w + turned);
    }
    for _ in 0..steps as usize {
        rod.step();
    }
    let (middle, end) = (rod.chain.displacement(parts / 2), rod.chain.displacement(parts));
    [middle.0, middle.1, end.2, rod.chain.displacement(parts / 4).1]
}

fn distance(a: [f64; 4], b: [f64; 4]) -> f64 {
    (0..4).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// Successive differences fall to a quarter as the elements or the step are halved: second order,
/// the order of a rod with lumped mass and a leapfrog scheme.
#[test]
fn the_rod_converges_with_the_square_of_element_and_step() {
    let by_mesh = [8, 16, 32, 64].map(|parts| struck(parts, 0.25));
    let by_step = [1.0, 0.5, 0.25, 0.125].map(|part| struck(16, part));
    for (name, answers) in [("element", by_mesh), ("step", by_step)] {
        let gaps = [0, 1, 2].map(|i| distance(answers[i], answers[i + 1]));
        let order = (gaps[1] / gaps[2]).log2();
        verify("order", format!("order in the {name}"))
            .absolute(0.05, "the next order's share, a few hundredths at the finest three")
            .report(2.0, order);
    }
}
