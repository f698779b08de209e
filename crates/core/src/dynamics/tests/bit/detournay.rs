//! Detournay and Defourny's law in its three regimes.

use wholestring_verification::verify;

use super::{
    regenerative::{identities, pressed},
    *,
};
use crate::dynamics::boundary::bit::{BitLaw, Cutters, DetournayDefournyLaw};

const TAU: f64 = std::f64::consts::TAU;

/// The bit and the rock of E07, its flats in full contact from 2 mm on, its bottom choked at 20 mm.
fn law() -> DetournayDefournyLaw {
    DetournayDefournyLaw {
        cutters: identities().0.cutters,
        full_contact_depth_m: 2e-3,
        cleaning_limit_m: Some(20e-3),
        rock_stiffness_N_per_m: 1e8,
        excitation: None,
    }
}

fn settings(law: DetournayDefournyLaw) -> BitSettings {
    BitSettings { law: BitLaw::DetournayDefourny(law), ..BitSettings::default() }
}

/// Turned at a speed that no torque changes.
fn turned(law: DetournayDefournyLaw, start_N: f64, speed: f64) -> Rig {
    let mut rig = Rig::with(pressed(start_N), settings(law));
    node!(rig.chain, 0, inv_polar = 0.0);
    rig.set_spin(speed);
    rig
}

fn check(quantity: &str, expected: f64, computed: f64) {
    verify("E07", quantity)
        .relative(1e-7, "rounding: 2e-13 m of a depth of 2000 m, over the 4 µm of a step")
        .report(expected, computed);
}

/// Lowered at the rate of E07 and turned at its speed, the bit takes the weight and torque of E07
/// and cuts its depth, and for that weight the law returns the depth and the rate.
#[test]
fn the_identities_hold_in_full_contact() {
    let (_, file) = identities();
    let as_f64 = |name: &str| file["expected"][name].as_f64().expect("a number");
    let speed = file["inputs"]["rpm"].as_f64().expect("a number") * TAU / 60.0;
    let rate = file["inputs"]["ROP_m_per_h"].as_f64().expect("a number") / 3600.0;
    let depth = as_f64("depth_of_cut_per_rev_m");
    let law = law();
    assert!((law.weight_on_bit_N(depth) / as_f64("WOB_N") - 1.0).abs() < 1e-12);
    let steady = law.steady(as_f64("WOB_N"), speed);
    for (found, expected) in [
        (steady.depth_of_cut_m, depth),
        (steady.torque_N_m, as_f64("TOB_Nm")),
        (steady.rate_of_penetration_m_per_s, rate),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    let mut rig = turned(law, 80e3, speed);
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, rate));
    assert!((rig.step(5e-4).weight_on_bit_N / as_f64("WOB_N") - 1.0).abs() > 0.1);
    let step = (0..20_000).map(|_| rig.step(5e-4)).last().expect("a step");
    for (quantity, expected, computed) in [
        ("three regimes: weight on bit, N", as_f64("WOB_N"), step.weight_on_bit_N),
        ("three regimes: torque on bit, N·m", as_f64("TOB_Nm"), step.torque_N_m),
        ("three regimes: depth of cut, m", depth, step.depth_of_cut_m),
        ("three regimes: rate of penetration, m/s", rate, step.rate_of_penetration_m_per_s),
    ] {
        check(quantity, expected, computed);
    }
}

/// Pushed with a weight of each regime, the bit drills at the closed form's rate with its torque.
/// E07: `ζ a ε` is 3.888 MN/m, the flats carry 71.28 kN, full contact begins at 79.056 kN and the
/// cleaning limit with 149.04 kN.
#[test]
fn each_regime_drills_by_its_closed_form() {
    let (arm, zeta, friction_torque) = (0.5 * 0.108, 0.6, 0.6);
    let (cutting, flats, full, limit) = (3.888e6, 71.28e3, 2e-3, 20e-3);
    for (regime, weight, depth) in [
        ("I", 30e3, 30e3 / (cutting + flats / full)),
        ("II", 110e3, (110e3 - flats) / cutting),
        ("III", 200e3, limit),
    ] {
        let cuts = cutting * depth;
        let torque = arm * (cuts / zeta + friction_torque * (weight - cuts));
        let speed = 7.0;
        let mut rig = turned(law(), 100e3, speed);
        rig.push = Vector(0.0, 0.0, weight);
        let step = (0..80_000).map(|_| rig.step(5e-4)).last().expect("a step");
        let rate = depth * speed / TAU;
        for (quantity, expected, computed) in [
            ("depth of cut, m", depth, step.depth_of_cut_m),
            ("torque, N·m", torque, step.torque_N_m),
            ("rate of penetration, m/s", rate, rig.chain.velocity(0).2),
        ] {
            let quantity = format!("regime {regime} under {:.0} kN: {quantity}", weight * 1e-3);
            verify("E07", &quantity)
                .relative(1e-6, "rounding of a depth of 2000 m over a step of 1 µm")
                .report(expected, computed);
        }
    }
}

/// The depth cut under a weight is the depth that requires this weight, from the first touch to the
/// cleaning limit, also where the flats carry weight at zero depth; nothing beyond the limit cuts
/// more.
#[test]
fn weight_and_depth_are_each_others_inverse() {
    for full_contact_depth_m in [0.0, 0.3e-3, 2e-3] {
        let law = DetournayDefournyLaw { full_contact_depth_m, ..law() };
        for i in 1..=200 {
            let depth = 1e-4 * f64::from(i);
            let found = law.depth_of_cut_m(law.weight_on_bit_N(depth));
            assert!((found / depth - 1.0).abs() < 1e-12, "{found} {depth}");
        }
        let limit = law.weight_on_bit_N(20e-3);
        assert_eq!(law.depth_of_cut_m(1.5 * limit), law.depth_of_cut_m(limit * 1.01));
    }
    // Without a cleaning limit there is no limit of the weight.
    let endless = DetournayDefournyLaw { cleaning_limit_m: None, ..law() };
    assert!((endless.depth_of_cut_m(71.28e3 + 3.888e6) - 1.0).abs() < 1e-12);
}

/// A core bit in the scaled forces of Detournay and Defourny, `w = W/a(1 − ρ)` and `t = 2T/a²(1 −
/// ρ²)`: at any weight on the flats, it drills on the friction line `t = (1 − μγζ) ε d + μγ w`.
#[test]
fn a_core_bit_drills_on_the_same_friction_line() {
    let whole = law();
    for ratio in [0.0, 0.3, 0.6] {
        let a = whole.cutters.radius_m;
        let law = DetournayDefournyLaw {
            cutters: Cutters { core_radius_m: ratio * a, ..whole.cutters },
            ..whole
        };
        for weight in [20e3, 60e3, 120e3, 300e3] {
            let cut = law.steady(weight, 5.0);
            let w = weight / (a * (1.0 - ratio));
            let t = 2.0 * cut.torque_N_m / (a * a * (1.0 - ratio * ratio));
            let line = (1.0 - 0.36) * 60e6 * cut.depth_of_cut_m + 0.6 * w;
            assert!((t / line - 1.0).abs() < 1e-12, "{ratio} {weight}: {t} {line}");
        }
        // In full contact the ring that is left takes its share of the weight.
        let (some, all) = (law.weight_on_bit_N(9e-3), whole.weight_on_bit_N(9e-3));
        assert!((some / all - (1.0 - ratio)).abs() < 1e-12);
    }
}

/// Lowered at a rate, the bit's weight approaches that of the rate as `e^(−k s t)`, `s = Ω/2π ζ a
/// ε` in full contact; the error of the implicit front is of first order in the step.
#[test]
fn the_weight_follows_a_change_of_rate_in_first_order() {
    let (speed, rate, start) = (7.0, 0.012, 100e3);
    let slope = speed / TAU / 3.888e6;
    let end = 71.28e3 + rate / slope;
    let error = |dt: f64| {
        let mut rig = turned(law(), start, speed);
        node!(rig.chain, 0, inv_mass_axial = 0.0);
        rig.chain.set_velocity(0, Vector(0.0, 0.0, rate));
        let steps = (0.03 / dt).round() as usize;
        let step = (0..steps).map(|_| rig.step(dt)).last().expect("a step");
        let exact = end + (start - end) * (-1e8 * slope * 0.03).exp();
        (step.weight_on_bit_N - exact).abs()
    };
    let errors = [1e-3, 5e-4, 2.5e-4].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((0.9..1.1).contains(&order), "{errors:?}");
    }
    assert!(errors[1] < 0.01 * (end - start).abs(), "{errors:?}");
}

/// A bit driven with less than its torque stops and cuts nothing however long it is pushed; driven
/// with more it continues from its position.
#[test]
fn a_stalled_bit_waits_and_goes_on() {
    let dt = 5e-4;
    let mut rig = Rig::with(pressed(110e3), settings(law()));
    rig.push = Vector(0.0, 0.0, 110e3);
    let torque = law().torque_N_m(110e3);
    rig.turn = 0.98 * torque;
    for _ in 0..4000 {
        let step = rig.step(dt);
        assert_eq!((rig.spin(), step.rate_of_penetration_m_per_s), (0.0, 0.0));
        assert!((step.torque_N_m / rig.turn - 1.0).abs() < 1e-9);
    }
    let stood = rig.chain.displacement(0).2;
    assert!(stood.abs() < 1e-6);
    rig.turn = 1.02 * torque;
    let mut cut = 0.0;
    for _ in 0..4000 {
        cut += dt * rig.step(dt).rate_of_penetration_m_per_s;
    }
    assert!(rig.spin() > 0.0 && cut > 1e-3);
    // The front is below the bit by its compression under the weight.
    assert!((rig.chain.displacement(0).2 - cut).abs() < 1e-4);
}

#[test]
fn work_is_the_change_of_kinetic_energy() {
    assert_work_is_the_change_of_energy(&mut Rig::with(pressed(110e3), settings(law())));
}
