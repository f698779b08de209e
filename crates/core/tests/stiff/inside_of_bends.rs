//! A string that lies on the inside of a bend is shorter than the hole's axis.

use wholestring::{
    prelude::*,
    string::{ComponentLength, ComponentSpec},
    well::Interpolation,
};

use crate::{common, settings, solve};

/// Without friction only the weight does work as the string slides, whatever the wall does: the
/// hook carries `w (z_low − z_top) − T²/2EA`. `z_low` is the depth of the low side, on which the
/// string lies above its bit, for the shape of the last metres moves along the hole with the bit;
/// `z_top` that of its top on the axis, above the surface by the stretch of the string and its
/// shortcut on the inside of the bend; the last term is that of an elastic string, whose weight per
/// stretched length is less. The bit is where the operation has it.
///
/// Tolerances: the bit within a millimetre, the hook load within 3e-6, of which 1e-6 is found. With
/// the shortcut counted twice the bit was 47 mm deeper, and the hook load 3e-5 more.
#[test]
fn the_shortcut_is_counted_once() {
    const DEPTH_M: f64 = 1500.0;
    let stations = [[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [900.0, 60.0, 0.0], [DEPTH_M, 60.0, 0.0]];
    let path = common::path(&stations, Interpolation::MinimumCurvature);
    let pipe =
        ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, common::steel());
    let hole = common::open_hole(0.2159, 0.0, DEPTH_M);
    let model = common::model(path, hole, vec![pipe], common::mud(1200.0), DEPTH_M);
    let found = solve(&model, &Operation::trip_out(DEPTH_M), &settings(2.0));
    let last = found.md_m.len() - 1;
    let deeper_m = found.md_m[last] - DEPTH_M;
    assert!(deeper_m.abs() < 1e-3, "the bit is {deeper_m} m deeper");
    let component = &model.string.components()[0];
    let weight_N_per_m = component.buoyed_weight_per_length_N_per_m(1200.0);
    let z_m = |md_m: f64| model.well.path.at(md_m).position_m.z;
    let clearance_m = 0.5 * (0.2159 - 0.127);
    let low_m = z_m(DEPTH_M) + clearance_m * 60.0_f64.to_radians().sin();
    let weight_N = weight_N_per_m * (low_m - z_m(found.md_m[0]));
    let expected_N = weight_N - weight_N * weight_N / (2.0 * component.axial_stiffness_N());
    common::assert_close("hook load", found.scalars.hook_load_N, expected_N, 3e-6);
}
