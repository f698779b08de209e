use std::f64::consts::{FRAC_PI_2, PI};

use super::*;
use crate::{
    common::{assert_close, operation, straight_model, uniform_model},
    operation::OperationKind,
    outcome::{QuantityKind, SCALARS},
};

const W_N_PER_M: f64 = 300.0;
const RADIUS_M: f64 = 0.07;
const MU: f64 = 0.3;

fn at(model: &Model, kind: OperationKind, down_m: f64) -> Scalars {
    let operation = operation(kind, model.string.length_m()).trip_speed_m_per_s(0.2);
    scalars_at(model, &operation, &SoftSettings::default(), down_m).expect("sound input")
}

/// In a straight hole it is the same everywhere, its top above the surface or below it: every
/// scalar but the depths, to rounding. The stretch is a square of the length, of which the first
/// order is left out at one end as at the other.
#[test]
fn a_straight_hole_is_the_same_everywhere() {
    let model = straight_model(40.0, 1200.0, W_N_PER_M, RADIUS_M, MU);
    for kind in [OperationKind::TripOut, OperationKind::TripIn, OperationKind::Ream] {
        for down_m in [1.0, 30.0] {
            let ends = [-down_m, down_m].map(|down_m| at(&model, kind, down_m));
            for scalar in
                SCALARS.iter().filter(|scalar| scalar.quantity.kind != QuantityKind::Depth)
            {
                let name = scalar.quantity.name;
                let [above, below] =
                    ends.each_ref().map(|scalars| (scalar.of)(scalars).expect(name));
                assert!((below - above).abs() <= 1e-9 * above.abs(), "{name}: {below}, {above}");
            }
        }
    }
}

/// A string that is pulled out of a lateral through a build of 90°, in contact with the upper side
/// all along: of each metre further in, the lateral takes `μ w`, the build makes `μ w e^(μ π/2)` of
/// it, and `w` no longer hangs in the vertical part.
///
/// Where it is in contact with one side of a build in one plane the soft string is linear in the
/// tension below: the tolerance is that of its steps, 3e-7 left, and of the difference, 1e-9.
#[test]
fn a_lateral_takes_the_weight_and_the_build_multiplies_its_drag() {
    const BUILD_RADIUS_M: f64 = 300.0;
    let landed_m = 1000.0 + BUILD_RADIUS_M * FRAC_PI_2;
    let stations = [
        [0.0, 0.0, 0.0],
        [1000.0, 0.0, 0.0],
        [landed_m, 90.0, 0.0],
        [landed_m + 2000.0, 90.0, 0.0],
    ];
    let model = uniform_model(&stations, W_N_PER_M, RADIUS_M, MU);
    let [above, below] = [-1.0, 1.0].map(|down_m| at(&model, OperationKind::TripOut, down_m));
    let per_metre = |scalar: fn(&Scalars) -> f64| 0.5 * (scalar(&below) - scalar(&above));
    let drag = MU * W_N_PER_M * (MU * PI / 2.0).exp();
    for (what, found, expected) in [
        ("hook load", per_metre(|scalar| scalar.hook_load_N), drag - W_N_PER_M),
        ("axial friction", per_metre(|scalar| scalar.axial_friction_N), drag),
        ("side force", per_metre(|scalar| scalar.side_force_total_N), drag / MU),
    ] {
        assert_close(what, found, expected, 1e-6);
    }
}

#[test]
fn a_bit_above_the_surface_is_refused() {
    let model = straight_model(0.0, 10.0, W_N_PER_M, RADIUS_M, MU);
    let operation = operation(OperationKind::TripOut, 10.0);
    let found = scalars_at(&model, &operation, &SoftSettings::default(), -10.0);
    assert_eq!(found, Err(SoftError::BitDepth(0.0)));
}
