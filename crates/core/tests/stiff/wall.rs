//! How far a wall gives way.

use wholestring::{
    findings::{Kind, Level, of_no_equilibrium, of_stiff},
    prelude::*,
    statics::stiff::{self, StiffError, StiffSettings},
    wall::contact::ContactLaw,
};

use crate::{common, settings, solve};

/// A wall that gives way by more than the string's clearance is none: the error says where and by how
/// much, and is a finding. One that gives way by a tenth of it is warned of; steel and rock are not.
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
    let finding = of_no_equilibrium(&soft).pop().expect("a finding");
    assert_eq!((finding.kind, finding.level), (Kind::WallPenetration, Level::Error));
    let found = solve_on(load_N / (0.3 * clearance_m)).expect("an equilibrium");
    let warned = of_stiff(&model, &trip, &found);
    let warned = warned.iter().find(|of| of.kind == Kind::WallPenetration).expect("a finding");
    assert_eq!(warned.level, Level::Warning);
    let hertz = solve(&model, &trip, &StiffSettings::default());
    assert!(of_stiff(&model, &trip, &hertz).iter().all(|of| of.kind != Kind::WallPenetration));
}
