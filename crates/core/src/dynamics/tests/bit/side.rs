//! The bit cutting its hole sideways.

use super::*;

/// Pushed sideways, the bit moves with `s (v/W)/Ω |Ω| F`: by its steerability times the axial rate
/// under the same force, and with the speed.
#[test]
fn the_bit_cuts_sideways_with_force_and_speed() {
    for (steerability, speed, side) in [(0.05, 7.0, 4e3), (0.05, 3.5, 4e3), (0.01, 7.0, -9e3)] {
        let settings = BitSettings { steerability, ..BitSettings::default() };
        let mut rig = Rig::with(OPERATION, settings);
        node!(rig.chain, 0, inv_polar = 0.0);
        rig.set_spin(speed);
        rig.push = Vector(side, 0.5 * side, 60e3);
        for _ in 0..60_000 {
            rig.step(5e-4);
        }
        let rate = steerability * 0.003 / 60e3 * speed / 7.0;
        let velocity = rig.chain.velocity(0);
        assert!((velocity.0 / (rate * side) - 1.0).abs() < 1e-6, "{velocity:?}");
        assert!((velocity.1 / (rate * 0.5 * side) - 1.0).abs() < 1e-6);
    }
}

/// A bit that does not turn, or is off bottom, cuts nothing: it is pushed into the rock's spring,
/// and comes back.
#[test]
fn a_bit_that_stands_or_hangs_does_not_cut() {
    let settings = BitSettings { steerability: 0.05, ..BitSettings::default() };
    let stands = Rig::with(OPERATION, settings.clone());
    let mut hangs =
        Rig::with(Operation { kind: OperationKind::RotateOffBottom, ..OPERATION }, settings);
    hangs.set_spin(7.0);
    for mut rig in [stands, hangs] {
        rig.push = Vector(4e3, 0.0, 0.0);
        for _ in 0..200_000 {
            rig.step(5e-4);
        }
        assert!((rig.chain.displacement(0).0 / (4e3 / 1e7) - 1.0).abs() < 1e-6);
        rig.push = Vector::zero();
        for _ in 0..200_000 {
            rig.step(5e-4);
        }
        assert!(rig.chain.displacement(0).0.abs() < 1e-9);
    }
}

#[test]
fn work_is_the_change_of_kinetic_energy() {
    let settings = BitSettings { steerability: 0.5, ..BitSettings::default() };
    assert_work_is_the_change_of_energy(&mut Rig::with(OPERATION, settings));
}
