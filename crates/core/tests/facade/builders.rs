//! Constructors give the documented values, and reject invalid ones.

use wholestring::{
    mud::CYLINDER_DRAG_COEFFICIENT,
    prelude::*,
    well::{HoleError, HoleKind},
};

#[test]
fn operations_have_their_kind_and_nothing_else() {
    for (operation, kind) in [
        (Operation::trip_out(900.0), OperationKind::TripOut),
        (Operation::trip_in(900.0), OperationKind::TripIn),
        (Operation::rotate_off_bottom(900.0), OperationKind::RotateOffBottom),
        (Operation::drill(900.0), OperationKind::Drill),
        (Operation::slide(900.0), OperationKind::Slide),
        (Operation::ream(900.0), OperationKind::Ream),
        (Operation::back_ream(900.0), OperationKind::BackReam),
    ] {
        assert_eq!(operation.kind, kind);
        assert_eq!(operation.bit_depth_m, 900.0);
        assert_eq!(operation.rotation_rad_per_s(), 0.0);
        assert_eq!(operation.weight_on_bit_now_N(), 0.0);
    }
    let set = Operation::slide(1.0)
        .rotary_speed_rad_per_s(2.0)
        .weight_on_bit_N(3.0)
        .bit_torque_N_m(4.0)
        .rate_of_penetration_m_per_s(5.0)
        .trip_speed_m_per_s(6.0)
        .flow_rate_m3_per_s(7.0)
        .bit_pressure_drop_Pa(8.0)
        .motor_pressure_drop_Pa(9.0)
        .bit_pull_N(10.0);
    let expected = Operation {
        kind: OperationKind::Slide,
        bit_depth_m: 1.0,
        rotary_speed_rad_per_s: 2.0,
        weight_on_bit_N: 3.0,
        bit_torque_N_m: 4.0,
        rate_of_penetration_m_per_s: 5.0,
        trip_speed_m_per_s: 6.0,
        flow_rate_m3_per_s: 7.0,
        bit_pressure_drop_Pa: 8.0,
        motor_pressure_drop_Pa: 9.0,
        bit_pull_N: 10.0,
    };
    assert_eq!(set, expected);
}

/// A rotating operation without a rotary speed is rejected with the set point's name.
#[test]
fn an_operation_without_its_set_points_is_refused() {
    let model = crate::setup::model();
    let error = soft_string(&model, &Operation::drill(crate::setup::BIT_DEPTH_M));
    let words = error.expect_err("it does not turn").to_string();
    assert!(words.contains("rotary speed"), "{words}");
}

#[test]
fn strings_from_the_catalogue() {
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
        .component(ComponentSpec::uniform("motor", 0.17, 0.08, Metres(9.0), Material::STEEL))
        .catalogue("5 in 19.50 lb/ft S-135", ToSurface)
        .expect("it is in the catalogue")
        .assemble(1000.0)
        .expect("a sound string");
    let names: Vec<&str> = string.components().iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["bit", "motor", "5 in 19.50 lb/ft S-135"]);
    assert!(string.components()[0].is_bit());
    assert_eq!(string.length_m(), 1000.0);

    let unknown = StringSpec::default().catalogue("5 in 20.5 lb/ft S-135", ToSurface);
    let words = unknown.expect_err("there is none").to_string();
    assert!(words.contains("`5 in 19.50 lb/ft S-135`"), "{words}");
}

#[test]
fn sections_have_the_wall_of_their_kind() {
    let casing = HoleSection::casing(0.0..500.0, 0.22, 0.2);
    let open = HoleSection::open(500.0..900.0, 0.21, 0.3);
    assert_eq!((casing.kind, open.kind), (HoleKind::Casing, HoleKind::Open));
    assert_eq!((open.from_md_m, open.to_md_m), (500.0, 900.0));
    assert_eq!(open.friction, Friction::uniform(0.3));
    for section in [casing, open] {
        let constants = (section.youngs_modulus_Pa, section.poisson_ratio);
        assert_eq!(constants, section.kind.elastic_constants());
    }
    let mud = Mud::of_density(1300.0);
    assert_eq!(mud.density_kg_per_m3, 1300.0);
    assert_eq!(mud.drag_coefficient, CYLINDER_DRAG_COEFFICIENT);
    assert!(mud.rheology.is_none());
}

/// Pieces of equal length fill each section, each with the friction at its middle.
#[test]
fn a_friction_profile_cuts_the_hole_into_pieces() {
    let hole = Hole::new(vec![
        HoleSection::casing(0.0..25.0, 0.22, 0.2),
        HoleSection::open(25.0..55.0, 0.21, 0.3),
    ])
    .expect("a sound hole");
    let varied = hole
        .with_friction_profile(10.0, |md_m| Friction::uniform(md_m / 100.0))
        .expect("sound coefficients");
    let ends: Vec<f64> = varied.sections().iter().map(|one| one.to_md_m).collect();
    assert_eq!(ends, [25.0 / 3.0, 50.0 / 3.0, 25.0, 35.0, 45.0, 55.0]);
    for section in varied.sections() {
        let middle_m = 0.5 * (section.from_md_m + section.to_md_m);
        assert_eq!(section.friction.kinetic, middle_m / 100.0);
    }
    assert_eq!(varied.sections()[3].kind, HoleKind::Open);

    for (length_m, coefficient) in [(0.0, 0.2), (f64::NAN, 0.2), (10.0, -0.1)] {
        let refused = hole.with_friction_profile(length_m, |_| Friction::uniform(coefficient));
        assert!(matches!(refused, Err(HoleError::OutOfRange { .. })));
    }
}
