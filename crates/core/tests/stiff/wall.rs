//! Penetration of a wall.

use wholestring::{
    prelude::*,
    statics::stiff::{self, StiffError, StiffProfile, StiffSettings},
    wall::contact::ContactLaw,
};

use crate::{common, settings, solve};

/// A penetration that exceeds the string's clearance is an error, with its depth and its amount. A
/// penetration of a tenth of it is solved; steel and rock have far smaller ones.
#[test]
fn a_wall_that_gives_way_is_not_trusted() {
    let model = common::straight_model(60.0, 300.0, 300.0, 0.0635, 0.3);
    let trip = Operation::trip_out(300.0);
    let solve_on = |stiffness_N_per_m: f64| {
        let contact_law = ContactLaw::Linear { stiffness_N_per_m, damping_ratio: 0.0 };
        stiff::solve(&model, &trip, &StiffSettings { contact_law, ..settings(5.0) })
    };
    let load_N = 300.0 * 60.0_f64.to_radians().sin() * 5.0;
    let soft = solve_on(load_N).expect_err("a metre through the wall");
    let StiffError::ThroughWall { penetration_m, clearance_m, .. } = soft else { panic!("{soft}") };
    assert!(penetration_m > 0.9 && clearance_m < 0.2, "{soft}");
    let deepest = |found: &StiffProfile| found.deepest_penetration_m[0] / clearance_m;
    let tenths = deepest(&solve_on(load_N / (0.3 * clearance_m)).expect("an equilibrium"));
    assert!((0.1..1.0).contains(&tenths), "{tenths}");
    let hertz = deepest(&solve(&model, &trip, &StiffSettings::default()));
    assert!(hertz < 0.1, "{hertz}");
}
