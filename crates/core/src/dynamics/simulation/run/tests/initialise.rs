//! Beginning of a run.

use super::*;
use crate::{
    dynamics::{
        boundary::bit::{BitLaw, BitSettings, RockLaw, RunIn, Standing},
        kernel::chain::element,
        settings::Start,
    },
    rock::{BitShape, DrillingSpec, Rock, bit_face::PdcBit},
};

const WEIGHT_N: f64 = 1500.0;

/// A bit of 60 mm on a rock of 10 MPa.
fn on_rock() -> DynamicsSettings {
    let bit = BitShape::Pdc(PdcBit::for_diameter(0.06));
    let drilling = DrillingSpec::new(Rock::for_drilling(10e6), bit, 6e-3).unwrap();
    DynamicsSettings {
        bit: BitSettings {
            law: BitLaw::Rock(Box::new(RockLaw { drilling })),
            ..BitSettings::default()
        },
        // The friction torque and the weight of the lowest node are compared with the bit's torque
        // and weight.
        mesh: MeshSettings::uniform(3.2),
        ..DynamicsSettings::default()
    }
}

/// Drilling with it, or sliding.
fn drill(kind: OperationKind) -> Operation {
    Operation {
        kind,
        rotary_speed_rad_per_s: 20.0,
        weight_on_bit_N: WEIGHT_N,
        // Far from the torque of the rock.
        bit_torque_N_m: 900.0,
        rate_of_penetration_m_per_s: 0.02,
        ..REAM
    }
}

/// The wall does not reach the bit, and no spring holds it while the string is initialised: it
/// begins on the hole's axis all the same, and the string hangs over it in balance. Let go
/// meanwhile it fell by six centimetres, and was torn back with 600 kN.
#[test]
fn the_bit_begins_on_the_axis() {
    let settings = DynamicsSettings::default();
    let mut run = new_run(&model(0.25), &REAM, &settings);
    let last = run.chain.nodes() - 1;
    let across_m = |run: &Run<f64>| {
        let (at, along) = (run.chain.displacement(last), run.chain.tangent(last));
        let across = at.minus(along, at.dot(along));
        across.dot(across).sqrt()
    };
    let begins_m = across_m(&run);
    assert!(begins_m < 1e-12, "{begins_m} m off the axis");
    // Compression of the spring by the weight of the last element.
    let weight_N = node!(run.chain, last, mass_lateral) * crate::GRAVITY_M_PER_S2;
    let pressed_m = 2.0 * weight_N / settings.bit.lateral_stiffness_N_per_m;
    run.advance(0.5).unwrap();
    let gets_m = across_m(&run);
    assert!(gets_m < pressed_m, "{gets_m} m, expected {pressed_m} m");
}

/// The string is wound up by the torque of the rock on the bit that was run in, not by the expected
/// torque.
#[test]
fn the_rock_winds_the_string_up() {
    let (settings, drill) = (on_rock(), drill(OperationKind::Drill));
    let run = new_run(&model(0.25), &drill, &settings);
    let last = run.chain.nodes() - 1;
    let standing = Standing {
        weight_N: WEIGHT_N,
        rate_m_per_s: drill.rate_of_penetration_m_per_s,
        string_rad_per_s: drill.rotary_speed_rad_per_s,
        mass_kg: node!(run.chain, last, mass_axial),
    };
    let run_in = RunIn::new(&settings.bit, &drill, standing, &RockExecutor::default());
    let expected_N_m = run_in.unwrap().expect("rock").torque_N_m();
    assert!((10.0..100.0).contains(&expected_N_m), "{expected_N_m}");
    // Half of the lowest node's friction torque acts above the bit.
    let twist_rad = element!(run.chain, last - 1, twist);
    let wound_N_m = -twist_rad * element!(run.chain, last - 1, torsion);
    let rubbed_N_m = 10.0;
    assert!(
        (0.0..rubbed_N_m).contains(&(wound_N_m - expected_N_m)),
        "{wound_N_m} for {expected_N_m}"
    );
}

/// A bit that does not turn, of a string that slides or starts centred, rests on its rock, which
/// carries its weight, and has no torque.
#[test]
fn a_bit_that_does_not_turn_rests_on_its_rock() {
    for (start, kind) in
        [(Start::Prepared, OperationKind::Slide), (Start::Centred, OperationKind::Drill)]
    {
        let settings = DynamicsSettings { start, ..on_rock() };
        // The block is stationary.
        let still = drill(kind).rate_of_penetration_m_per_s(0.0);
        let mut run = new_run(&model(0.25), &still, &settings);
        assert!(element!(run.chain, run.chain.nodes() - 2, twist) == 0.0);
        run.advance(0.02).unwrap();
        // The string has only been settled across the hole: along it, it gives by a tenth. A
        // hanging bit would have no weight.
        for weight_N in &run.outcome().series.weight_on_bit_N {
            assert!((weight_N / WEIGHT_N - 1.0).abs() < 0.2, "{weight_N} N");
        }
    }
}
