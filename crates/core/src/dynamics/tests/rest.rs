//! A contact at rest holds more than one that slides.

use crate::{
    dynamics::kernel::{
        chain::{Chain, node},
        step::{Abilities, Laws, StepInput, Stepper},
    },
    simd::vector::Vector,
    wall::friction::STRIBECK_SPEED_M_PER_S,
};

const MASS_KG: f64 = 100.0;
const NORMAL_N: f64 = 2000.0;
const KINETIC: f64 = 0.25;
const AT_REST: f64 = 0.4;

/// A node on its wall under [`NORMAL_N`] and is pushed along it.
fn pushed(along_N: f64) -> Chain {
    let (clearance, stiffness) = (0.05, 1e10);
    let mut chain = Chain::new(1);
    node!(chain, 0, mass_axial = MASS_KG);
    node!(chain, 0, inv_mass_axial = 1.0 / MASS_KG);
    node!(chain, 0, mass_lateral = MASS_KG);
    node!(chain, 0, inv_mass_lateral = 1.0 / MASS_KG);
    node!(chain, 0, clearance = clearance);
    node!(chain, 0, radius = 0.07);
    node!(chain, 0, stiffness = stiffness);
    node!(chain, 0, friction = KINETIC);
    node!(chain, 0, friction_rise = AT_REST - KINETIC);
    chain.set_weight(0, Vector(NORMAL_N, 0.0, along_N));
    let sunk = (NORMAL_N / stiffness).powf(2.0 / 3.0);
    chain.set_displacement(0, Vector(clearance + sunk, 0.0, 0.0));
    chain
}

const STEP: StepInput =
    StepInput { dt: 1e-5, stiffness_damping: 0.0, dissipation: 0.5, stribeck_speed: 0.1 };

/// Pushed with less than `μ_s N`, it stays for ever, though `μ_k N` is far exceeded; with more, it
/// goes and gains speed by `m v' = F − N (μ_k + (μ_s − μ_k)/(1 + (v/v_s)²))`. With
/// `a = (F − μ_k N)/m`, `b = (μ_s − μ_k) N/m` and `x = v/v_s` that is
/// `t = v_s [x/a + b/(a √(a (a − b))) atan(x √(a/(a − b)))]`.
///
/// Within 0.2 % of `t`. The step takes the coefficient at the speed before friction, which is too
/// fast by `F dt/m`, 8e-5 m/s here: that makes the acceleration at `v_s/2` 0.15 % too large.
#[test]
fn a_contact_breaks_away() {
    for law in [true, false] {
        let mut stepper =
            Stepper::new(Abilities { laws: Laws { hertz: true, vector: law }, full: true });
        // A tenth of a second for the contact to find its force.
        let mut chain = pushed(0.999 * AT_REST * NORMAL_N);
        for _ in 0..10_000 {
            stepper.step(&mut chain, &STEP);
        }
        let before = chain.displacement(0).2;
        for _ in 0..50_000 {
            stepper.step(&mut chain, &STEP);
        }
        let moved = chain.displacement(0).2 - before;
        assert!(moved.abs() < 1e-12, "held, it moved by {moved} m");

        let force = 1.05 * AT_REST * NORMAL_N;
        let mut chain = pushed(force);
        let a = (force - KINETIC * NORMAL_N) / MASS_KG;
        let b = (AT_REST - KINETIC) * NORMAL_N / MASS_KG;
        let mut steps = 0u32;
        for x in [0.5, 1.0, 3.0, 10.0] {
            while chain.velocity(0).2 < x * STRIBECK_SPEED_M_PER_S {
                stepper.step(&mut chain, &STEP);
                steps += 1;
                assert!(steps < 1_000_000, "it does not slide");
            }
            let x = chain.velocity(0).2 / STRIBECK_SPEED_M_PER_S;
            let slow = (a * (a - b)).sqrt();
            let expected = STRIBECK_SPEED_M_PER_S
                * (x / a + b / (a * slow) * (x * (a / (a - b)).sqrt()).atan());
            let found = f64::from(steps) * STEP.dt;
            assert!((found / expected - 1.0).abs() < 2e-3, "{found} for {expected} s to {x}");
        }
    }
}
