//! The regenerative law.

use serde_json::Value;
use wholestring_verification::verify;

use super::*;
use crate::{
    common::verification,
    dynamics::boundary::bit::{BitLaw, Cutters, Motor, RegenerativeLaw},
};

const TAU: f64 = std::f64::consts::TAU;

pub(super) use crate::common::DRAG_BIT as LAW;

pub(super) fn settings(law: RegenerativeLaw) -> BitSettings {
    BitSettings { law: BitLaw::Regenerative(law), ..BitSettings::default() }
}

pub(super) fn pressed(weight_on_bit_N: f64) -> Operation {
    OPERATION.weight_on_bit_N(weight_on_bit_N)
}

pub(super) fn identities() -> (RegenerativeLaw, Value) {
    let file = verification("E07_bit_rock_detournay.json");
    let inputs = &file["inputs"];
    let as_f64 = |name: &str| inputs[name].as_f64().expect("a number");
    let cutters = Cutters {
        radius_m: as_f64("a_m"),
        core_radius_m: 0.0,
        intrinsic_specific_energy_Pa: as_f64("eps_Pa"),
        cutter_inclination: as_f64("zeta"),
        wear_flat_m: as_f64("wear_flat_l_m"),
        contact_strength_Pa: as_f64("sigma_Pa"),
        bit_geometry: as_f64("gamma"),
        friction: as_f64("mu"),
    };
    let blades = inputs["blades"].as_u64().expect("a number") as u32;
    (RegenerativeLaw { cutters, blades }, file)
}

/// Lowered at the rate of E07 and turned at its speed, the bit takes the weight and torque of E07
/// and cuts its depth; for that weight the law returns the rate. Rounding only: the file prints all
/// digits.
#[test]
fn steady_drilling_takes_the_weight_and_torque_of_the_identities() {
    let (law, file) = identities();
    let as_f64 = |name: &str| file["expected"][name].as_f64().expect("a number");
    let speed = file["inputs"]["rpm"].as_f64().expect("a number") * TAU / 60.0;
    let rate = file["inputs"]["ROP_m_per_h"].as_f64().expect("a number") / 3600.0;
    let steady = law.steady(as_f64("WOB_N"), speed);
    let close = |a: f64, b: f64, tolerance: f64| (a / b - 1.0).abs() < tolerance;
    assert!(close(steady.depth_of_cut_m, as_f64("depth_of_cut_per_rev_m"), 1e-12));
    assert!(close(steady.torque_N_m, as_f64("TOB_Nm"), 1e-12));
    assert!(close(steady.rate_of_penetration_m_per_s, rate, 1e-12));

    // It starts with another weight's bottom: one revolution and it has forgotten that.
    let mut rig = Rig::with(pressed(80e3), settings(law));
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    node!(rig.chain, 0, inv_polar = 0.0);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, rate));
    rig.set_spin(speed);
    let mut step = rig.step(5e-4);
    assert!(!close(step.weight_on_bit_N, as_f64("WOB_N"), 0.1), "{step:?}");
    for _ in 0..8000 {
        step = rig.step(5e-4);
    }
    for (quantity, expected, computed) in [
        ("weight on bit, N", "WOB_N", step.weight_on_bit_N),
        ("torque on bit, N·m", "TOB_Nm", step.torque_N_m),
        ("depth of cut, m", "depth_of_cut_per_rev_m", step.depth_of_cut_m),
    ] {
        verify("E07", quantity)
            .relative(1e-9, "rounding: 2e-13 m of a depth of 2000 m, over 4 mm")
            .report(as_f64(expected), computed);
    }
}

/// A bit that is led up and down on its way cuts `U(Φ) − U(Φ − 2π/n)`, whatever the step, and half
/// the bottom's spacing would be a quarter of the error: lines between points `h` apart are off by
/// `h² U″/8`.
#[test]
fn the_cut_is_what_the_blade_before_has_left() {
    let (waves, amplitude, pitch) = (23.0, 1e-4, 5e-4);
    let depth = |angle: f64| pitch * angle + amplitude * (waves * angle).sin();
    for dt in [1e-3, 1.3e-4] {
        let mut rig = Rig::with(pressed(80e3), settings(LAW));
        node!(rig.chain, 0, inv_mass_axial = 0.0);
        node!(rig.chain, 0, inv_polar = 0.0);
        rig.set_spin(7.0);
        let steps = (3.0 / dt) as usize;
        let mut angle = 0.0;
        for i in 0..steps {
            let next = angle + 7.0 * dt;
            let v = (depth(next) - depth(angle)) / dt;
            rig.chain.set_velocity(0, Vector(0.0, 0.0, v));
            let step = rig.step(dt);
            angle = next;
            if i > steps / 2 {
                let cut = 4.0 * (depth(angle) - depth(angle - TAU / 4.0)).max(0.0);
                let error = (step.depth_of_cut_m - cut).abs();
                // The path between steps is straight, too.
                let spacing = (TAU / 4096.0).max(7.0 * dt);
                let line = 4.0 * amplitude * waves * waves * spacing * spacing / 8.0;
                assert!(error < 2.1 * line + 1e-11, "{i}: {error} {line}");
            }
        }
    }
}

/// Lifted, the bit leaves the rock, and the rock that it did not cut is there when it returns: the
/// next blade cuts twice as deep.
#[test]
fn a_lifted_bit_leaves_rock_standing() {
    let mut rig = Rig::with(pressed(80e3), settings(LAW));
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    node!(rig.chain, 0, inv_polar = 0.0);
    let (dt, speed) = (1e-4, 7.0);
    rig.set_spin(speed);
    let steady = LAW.steady(80e3, speed);
    let sector = TAU / 4.0 / speed;
    let mut time = 0.0;
    let mut go = |rig: &mut Rig, until: f64, to: &dyn Fn(f64) -> f64| {
        let mut step = BitStep::default();
        while time < until {
            time += dt;
            let v = (to(time) - rig.chain.displacement(0).2) / dt;
            rig.chain.set_velocity(0, Vector(0.0, 0.0, v));
            step = rig.step(dt);
        }
        step
    };
    let rate = steady.rate_of_penetration_m_per_s;
    let drills = |t: f64| rate * t;
    let before = go(&mut rig, 2.0 * sector, &drills);
    let off = go(&mut rig, 3.0 * sector, &|t| drills(t) - 0.1);
    let after = go(&mut rig, 3.5 * sector, &drills);
    let again = go(&mut rig, 4.5 * sector, &drills);
    assert!((before.depth_of_cut_m / steady.depth_of_cut_m - 1.0).abs() < 1e-6);
    assert_eq!((off.weight_on_bit_N, off.torque_N_m), (0.0, 0.0));
    assert!((after.depth_of_cut_m / (2.0 * steady.depth_of_cut_m) - 1.0).abs() < 1e-6);
    assert!((again.depth_of_cut_m / steady.depth_of_cut_m - 1.0).abs() < 1e-6);
}

/// The wear flats carry their full weight while the bit moves down, none while it moves up, and the
/// weight needed for equilibrium while it is stationary.
#[test]
fn wear_flats_bear_on_the_way_down() {
    let bearing = LAW.cutters.wear_flat_weight_N();
    let moving = |velocity: f64| {
        let mut rig = Rig::with(pressed(80e3), settings(LAW));
        node!(rig.chain, 0, inv_mass_axial = 0.0);
        rig.chain.set_velocity(0, Vector(0.0, 0.0, velocity));
        let step = rig.step(1e-6);
        step.weight_on_bit_N - LAW.stiffness_N_per_m() * step.depth_of_cut_m / 4.0
    };
    assert!((moving(1e-3) - bearing).abs() < 1e-6 * bearing);
    assert!(moving(-1e-3).abs() < 1e-6 * bearing);
    // It is stationary, does not turn, and is pushed with less than before: nothing moves.
    for push in [79e3, 75e3, 73e3] {
        let mut rig = Rig::with(pressed(80e3), settings(LAW));
        rig.push = Vector(0.0, 0.0, push);
        let step = (0..2000).map(|_| rig.step(1e-4)).last().expect("a step");
        assert!((step.weight_on_bit_N - push).abs() < 1e-6 * push, "{step:?}");
        assert!(rig.chain.velocity(0).2.abs() < 1e-12);
        // At the steady depth of cut, the flats yield by the missing force.
        let needed = push - (80e3 - bearing);
        let torque = 0.5 * 0.108 * ((80e3 - bearing) / 0.6 + 0.6 * needed);
        rig.turn = 0.999 * torque;
        rig.step(1e-4);
        assert_eq!(rig.spin(), 0.0);
        rig.turn = 1.001 * torque;
        rig.step(1e-4);
        assert!(rig.spin() > 0.0);
    }
}

/// Turned back, only the wear flats rub; the cut continues where it was left.
#[test]
fn a_bit_turned_back_cuts_where_it_left() {
    let mut rig = Rig::with(pressed(80e3), settings(LAW));
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, 1e-9));
    node!(rig.chain, 0, inv_polar = 0.0);
    let rubbing = 0.5 * 0.108 * 0.6 * LAW.cutters.wear_flat_weight_N();
    rig.set_spin(1.0);
    let cutting = rig.step(1e-3).torque_N_m;
    rig.set_spin(-1.0);
    for _ in 0..100 {
        let back = rig.step(1e-3);
        assert!((back.torque_N_m / -rubbing - 1.0).abs() < 1e-9);
    }
    rig.set_spin(1.0);
    for _ in 0..99 {
        let again = rig.step(1e-3);
        assert!((again.torque_N_m / rubbing - 1.0).abs() < 1e-9);
    }
    rig.step(1e-3);
    let on = rig.step(1e-3);
    assert!((on.torque_N_m / cutting - 1.0).abs() < 1e-3);
}

/// The work of the rock is the change of the bit's kinetic energy, to rounding, through stick,
/// jumps and turning back.
#[test]
fn work_is_the_change_of_kinetic_energy() {
    assert_work_is_the_change_of_energy(&mut Rig::with(pressed(80e3), settings(LAW)));
}

/// A motor turns the bit while the string does not rotate: it drills at the motor's speed, and the
/// string carries the reaction.
#[test]
fn a_motor_cuts_while_the_string_stands() {
    let operation = Operation { kind: OperationKind::Slide, ..pressed(80e3) };
    let mut rig = Rig::with(operation, BitSettings { motor: Motor::Speed(12.0), ..settings(LAW) });
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    node!(rig.chain, 0, inv_polar = 0.0);
    let steady = LAW.steady(80e3, 12.0);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, steady.rate_of_penetration_m_per_s));
    for _ in 0..4000 {
        rig.step(5e-4);
    }
    let step = rig.step(5e-4);
    assert!((step.weight_on_bit_N / 80e3 - 1.0).abs() < 1e-9, "{step:?}");
    assert!((step.torque_N_m / steady.torque_N_m - 1.0).abs() < 1e-9);
    // Free to turn, the string is turned back as fast as the motor can, and there it ends.
    node!(rig.chain, 0, inv_polar = 1.0 / POLAR_KG_M2);
    for _ in 0..400 {
        rig.step(5e-4);
    }
    assert!((rig.spin() + 12.0).abs() < 1e-9, "{}", rig.spin());
}
