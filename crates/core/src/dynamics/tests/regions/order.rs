//! Order of convergence where regions have steps of their own.

use wholestring_verification::verify;

use super::equal;
use crate::{
    dynamics::{kernel::chain::node, tests::bench::Support},
    simd::vector::Vector,
};

const UPPER: usize = 12;

const TIME_S: f64 = 0.2;

/// A pipe struck along, across in two planes and about its axis, its lower half in three steps for
/// one: where nodes around the border are after a fifth of a second, with `part` of the longest
/// step. The inertia that the coupling lacks goes by the step.
fn struck(part: f64) -> Vec<f64> {
    let longest_s = equal(2 * UPPER, UPPER, 3, [1.0; 2]).plan.dt_s;
    let steps = (TIME_S / (part * longest_s)).round();
    let part = TIME_S / steps / longest_s;
    let mut rod = equal(2 * UPPER, UPPER, 3, [part, 1.0]).divided();
    rod.support(0, Support::PINNED);
    let k = 1.5 * std::f64::consts::PI / rod.mesh.length_m();
    for i in 1..rod.chain.nodes() {
        let z = rod.z_m(i);
        let wave = (k * z).sin();
        rod.chain.set_velocity(i, Vector(3.0 * wave, 2.0 * wave, 0.5 * wave));
        let tilt = k * (k * z).cos();
        rod.chain.set_turning(i, Vector(-2.0 * tilt, 3.0 * tilt, 0.0));
        node!(rod.chain, i, spin = 2.0 * wave);
    }
    for _ in 0..steps as usize {
        rod.step();
    }
    let places = [UPPER - 3, UPPER, UPPER + 1, UPPER + 4, 2 * UPPER];
    let motion = |i: usize| {
        let u = rod.chain.displacement(i);
        let turned = rod.chain.director(i);
        [u.0, u.1, u.2, turned.0, turned.1]
    };
    places.into_iter().flat_map(motion).collect()
}

/// Successive differences fall to a quarter as both steps are halved: second order, as without a
/// border.
#[test]
fn both_steps_together_converge_with_their_square() {
    let answers = [0.5, 0.25, 0.125, 0.0625].map(struck);
    let gap = |i: usize| {
        let pairs = answers[i].iter().zip(&answers[i + 1]);
        pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    let gaps = [0, 1, 2].map(gap);
    let order = (gaps[1] / gaps[2]).log2();
    verify("order", "order in both steps of a string in regions")
        .absolute(0.05, "the next order's share, a few hundredths at the finest three")
        .report(2.0, order);
}
