//! The clamp at the top.

use super::*;
use crate::simd::vector::Vector;

/// The clamp holds the top on the curved axis wherever it has slid to within the reach of its
/// anchor, and its director along it, with the speed that it had along it.
///
/// The clamp follows the axis to the third order of the distance `z` from the anchor: `κ' z³/6` of
/// the place and `κ' z²/2` of the direction, with the change of curvature `κ'`, here below 1e-5
/// 1/m². The tolerances are a hundredth of what a straight axis would miss, `κ z²/2` and `κ z`: the
/// wrong sign misses by twice that.
#[test]
fn the_top_is_clamped_to_a_curved_axis() {
    let mut run = new_run(&model(0.25), &REAM, &DynamicsSettings::default());
    let path = run.model.well.path.clone();
    run.borehole.place(&mut run.chain, &mut run.state.anchors, 0, 150.0);
    let anchor = run.state.anchors[0];
    let tangent = run.chain.tangent(0);
    let bend_per_m = path.at(150.0).curvature_per_m.norm();
    assert!(bend_per_m > 1e-3, "{bend_per_m}");
    for z in [-0.05, 0.02, 0.05] {
        let aside = tangent.cross(Vector(0.0, 1.0, 0.0)).scaled(0.01);
        run.chain.set_displacement(0, tangent.scaled(z) + aside);
        run.chain.set_director(0, tangent);
        run.chain.set_velocity(0, tangent.scaled(0.4) + aside);
        run.clamp_top();
        let there = path.at(150.0 + z);
        let director = run.chain.director(0);
        let turned = (Vector3::from(director) - there.tangent).norm();
        assert!(turned < 0.01 * bend_per_m * z.abs(), "{turned} at {z}");
        let found = anchor.position_m + Vector3::from(run.chain.displacement(0));
        let off = found - there.position_m;
        let off = (off - there.tangent * off.dot(&there.tangent)).norm();
        assert!(off < 0.01 * 0.5 * bend_per_m * z * z, "{off} at {z}");
        let velocity = run.chain.velocity(0);
        assert!(velocity.cross(director).dot(velocity.cross(director)) < 1e-20);
        assert!((velocity.dot(director) - 0.4).abs() < 1e-5);
    }
}
