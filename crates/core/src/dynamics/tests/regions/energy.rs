//! Effect of the coupling on the energy of a string without any loss.

use super::refined;
use crate::{
    dynamics::{
        body::Body,
        boundary::anchor::Anchor,
        kernel::chain::node,
        output::energy::Energies,
        tests::bench::{Bench, Support},
    },
    random::Random,
    simd::vector::Vector,
};

/// Kind of motion excited in a string.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Motion {
    Axial,
    Torsional,
    All,
}

/// Gives each node but the top velocities of its own along, across and about the axis, or of one of
/// these.
fn stir(rod: &mut Bench, motion: Motion) {
    let mut random = Random::new(1);
    for i in 1..rod.chain.nodes() {
        let mut next = |motions: &[Motion]| {
            let speed = 1e-3 * random.signed();
            if motion == Motion::All || motions.contains(&motion) { speed } else { 0.0 }
        };
        let velocity = Vector(next(&[]), next(&[]), next(&[Motion::Axial]));
        let spin = 10.0 * next(&[Motion::Torsional]);
        rod.chain.set_velocity(i, velocity);
        node!(rod.chain, i, spin = spin);
    }
}

fn energy_J(rod: &Bench) -> f64 {
    let up = nalgebra::Vector3::x();
    let anchor = |i: usize| Anchor {
        md_m: rod.z_m(i),
        position_m: nalgebra::Vector3::new(0.0, 0.0, rod.z_m(i)),
        high_side: up,
    };
    let anchors: Vec<_> = (0..rod.chain.nodes()).map(anchor).collect();
    Energies::of(&rod.chain, &anchors, &Body::default(), None, rod.input.dt).total()
}

/// Mean energy of the last tenth of so many steps over that of the first, less one. The energy at
/// one step fluctuates with every wave; the average over thousands of consecutive steps removes
/// this.
fn drift(rod: &mut Bench, steps: usize) -> f64 {
    let tenth = steps / 10;
    let mean = |rod: &mut Bench, read: bool| {
        let mut sum = 0.0;
        for step in 0..tenth {
            rod.step();
            if read {
                sum += energy_J(rod);
            }
            if step % 128 == 0 {
                rod.chain.renormalise();
            }
        }
        sum / tenth as f64
    };
    let first = mean(rod, true);
    for _ in 1..9 {
        mean(rod, false);
    }
    mean(rod, true) / first - 1.0
}

/// A string that loses nothing, stirred up in all its waves, those included that the border's
/// longer step cannot carry, keeps its energy over so many steps: within 1e-4, of which the mean
/// itself has an uncertainty of a few hundred thousandths, with one step for all of it as well. The
/// bands of an unstable coupling, 1e-3 a step, would have ended it in ten thousand.
fn energy_is_kept(steps: usize) {
    for parts in [2, 3, 4] {
        for motion in [Motion::Axial, Motion::Torsional, Motion::All] {
            let mut rod = refined(60, 20, parts);
            assert_eq!(rod.plan.subcycling.map(|s| s.parts), Some(parts as u32));
            rod.support(0, Support::CLAMPED);
            stir(&mut rod, motion);
            let drift = drift(&mut rod, steps);
            assert!(drift.abs() < 1e-4, "{motion:?} in {parts}: {drift:e}");
        }
    }
}

#[test]
fn an_undamped_string_keeps_its_energy() {
    energy_is_kept(100_000);
}

#[test]
#[ignore = "minutes: run by cargo xtask verify"]
fn an_undamped_string_keeps_its_energy_for_a_million_steps() {
    energy_is_kept(1_000_000);
}

/// With the border at the first short element, and none of ordinary length below it, the same
/// string gains energy without end.
#[test]
fn without_a_buffer_the_coupling_gains_energy() {
    let mut rod = refined(60, 20, 3);
    let mut planned = rod.plan.subcycling.expect("regions");
    planned.border_node = 59;
    rod.plan.subcycling = Some(planned);
    let mut rod = rod.divided();
    rod.support(0, Support::CLAMPED);
    stir(&mut rod, Motion::Axial);
    let before = energy_J(&rod);
    for _ in 0..20_000 {
        rod.step();
    }
    let gained = energy_J(&rod) / before;
    assert!(gained.is_nan() || gained > 10.0, "{gained}");
}
