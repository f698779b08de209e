use super::*;
use crate::{
    common::{arcs, model, np13, open_hole, operation, pressing, viscous_mud},
    mud::Rheology,
    operation::OperationKind::{BackReam, Drill, RotateOffBottom, Slide, TripIn, TripOut},
    statics::soft::solve,
};

const DEPTH_M: f64 = 1200.0;

/// Jointed pipe and its assembly in a well that builds, turns and drops, in a mud that flows.
fn winding() -> Model {
    let stations = [
        [0.0, 0.0, 0.0],
        [300.0, 0.0, 0.0],
        [700.0, 60.0, 20.0],
        [900.0, 80.0, 50.0],
        [DEPTH_M, 55.0, 50.0],
    ];
    let rheology = Rheology::Bingham { plastic_viscosity_Pa_s: 0.02, yield_point_Pa: 5.0 };
    let hole = open_hole(0.2159, 0.3, DEPTH_M);
    model(arcs(&stations), hole, np13::components(), viscous_mud(1200.0, rheology), DEPTH_M)
}

/// The data common to operations are computed once, and change no digit of any of them, in any
/// order.
#[test]
fn operations_on_one_string_answer_as_each_alone() {
    let model = winding();
    let operations = [
        operation(TripOut, DEPTH_M),
        operation(TripIn, DEPTH_M),
        operation(RotateOffBottom, DEPTH_M),
        pressing(Drill, DEPTH_M, 80e3),
        pressing(Slide, DEPTH_M, 60e3),
        operation(BackReam, DEPTH_M).rate_of_penetration_m_per_s(0.01),
    ];
    for settings in [SoftSettings::default(), SoftSettings { step_m: 7.0, helix_side_force: true }]
    {
        let string = SoftString::new(&model, DEPTH_M, &settings).expect("a string");
        for operation in operations.iter().chain(operations.iter().rev()) {
            let alone = solve(&model, operation, &settings).expect("an answer");
            assert_eq!(string.solve(operation).as_ref(), Ok(&alone));
            // The bit is where the string has it.
            let elsewhere = Operation { bit_depth_m: 1.0, ..*operation };
            assert_eq!(string.solve(&elsewhere).as_ref(), Ok(&alone));

            let loads = string.loads(operation).expect("loads");
            assert_eq!(loads.hook_load_N, alone.scalars.hook_load_N);
            assert_eq!(loads.surface_torque_N_m, alone.scalars.surface_torque_N_m);
            assert_eq!(loads.axial_friction_N, alone.scalars.axial_friction_N);
            assert_eq!(loads.hydraulics, alone.hydraulics);
            let (some, all) = (&loads.profile, &alone.profile);
            for (some, all) in [
                (&some.md_m, &all.md_m),
                (&some.tension_N, &all.tension_N),
                (&some.torque_N_m, &all.torque_N_m),
                (&some.bending_moment_N_m, &all.bending_moment_N_m),
                (&some.bending_moment_between_N_m, &all.bending_moment_between_N_m),
                (&some.outside_pressure_Pa, &all.outside_pressure_Pa),
                (&some.inside_pressure_Pa, &all.inside_pressure_Pa),
            ] {
                assert_eq!(some, all);
            }
            assert_eq!(some.sinusoidal_load_N, all.sinusoidal_load_N);
            assert_eq!(some.helical_load_N, all.helical_load_N);

            let least = |loads_N: &[Option<f64>]| {
                let rows = loads_N.iter().zip(&all.tension_N);
                let left = rows.filter_map(|(load_N, tension_N)| Some((*load_N)? + tension_N));
                left.fold(f64::INFINITY, f64::min)
            };
            let margins_N = [least(&all.sinusoidal_load_N), least(&all.helical_load_N)];
            assert_eq!(string.buckling_margins_N(operation), Ok(margins_N));
        }
    }
}

/// A fault of the string is reported as such, and a fault of an operation as one of the operation.
#[test]
fn string_and_operation_are_checked() {
    let (model, settings) = (winding(), SoftSettings::default());
    let error_for = |bit_depth_m, step_m| {
        SoftString::new(&model, bit_depth_m, &SoftSettings { step_m, ..settings }).err()
    };
    assert_eq!(error_for(-1.0, 1.0), Some(SoftError::BitDepth(-1.0)));
    assert_eq!(error_for(DEPTH_M, 0.0), Some(SoftError::Step(0.0)));
    assert!(matches!(error_for(900.0, 1.0), Some(SoftError::StringLength { .. })));
    let string = SoftString::new(&model, DEPTH_M, &settings).expect("a string");
    let still = operation(Drill, DEPTH_M).rotary_speed_rad_per_s(0.0);
    let is_refused = |error: Option<SoftError>| matches!(error, Some(SoftError::SetPoint { .. }));
    assert!(is_refused(string.solve(&still).err()));
    assert!(is_refused(string.loads(&still).err()));
    assert!(is_refused(string.buckling_margins_N(&still).err()));
}
