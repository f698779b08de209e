//! Where a run begins.

use super::*;

/// The wall does not reach the bit, and no spring holds it while the string is laid: it begins on the hole's axis all the same, and the
/// string hangs over it in balance. Let go meanwhile it fell by six centimetres, and was torn back with 600 kN.
#[test]
fn the_bit_begins_on_the_axis() {
    let settings = DynamicsSettings::default();
    let mut run = Run::<f64>::new(&model(0.25), &REAM, &settings).unwrap();
    let last = run.chain.nodes() - 1;
    let across_m = |run: &Run<f64>| {
        let (at, along) = (run.chain.displacement(last), run.chain.tangent(last));
        let across = at.minus(along, at.dot(along));
        across.dot(across).sqrt()
    };
    let begins_m = across_m(&run);
    assert!(begins_m < 1e-12, "{begins_m} m off the axis");
    // What the last element weighs presses the spring by so much.
    let weight_N = node!(run.chain, last, mass_lateral) * crate::GRAVITY_M_PER_S2;
    let pressed_m = 2.0 * weight_N / settings.bit.lateral_stiffness_N_per_m;
    run.advance(0.5).unwrap();
    let gets_m = across_m(&run);
    assert!(gets_m < pressed_m, "{gets_m} m, expected {pressed_m} m");
}
