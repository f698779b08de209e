//! A hook load that swings although nothing excites the string.

use wholestring::{
    dynamics::{DynamicsSettings, MeshSettings, Simulation},
    operation::OperationKind::TripOut,
    prelude::*,
    string::ToolJoints,
    well::Interpolation,
};
use wholestring_judge::{Check, CheckKind, Judge, Severity};

use crate::{
    common::{model, mud, operation, path, steel},
    judged::only,
};

/// 5 in drill pipe with tool joints every 9.6 m in a build of 3 deg/30 m to 42 deg.
fn slant() -> Model {
    let stations: Vec<[f64; 3]> = std::iter::once([0.0, 0.0, 120.0])
        .chain((0..15).map(|i| [210.0 + 30.0 * f64::from(i), 3.0 * f64::from(i), 120.0]))
        .chain([[1200.0, 42.0, 120.0]])
        .collect();
    let path = path(&stations, Interpolation::Spline);
    let sections = [(0.0, 650.0, 0.2244, 0.2), (650.0, 1200.0, 0.2159, 0.3)];
    let sections = sections.map(|(from_m, to_m, diameter_m, friction)| {
        HoleSection::open(from_m..to_m, diameter_m, friction)
    });
    let hole = Hole::new(sections.to_vec()).expect("a hole");
    let tool = |name, length, od_m, id_m| ComponentSpec::uniform(name, od_m, id_m, length, steel());
    let jointed = |spec: ComponentSpec, mass_per_length_kg_per_m, spacing_m| ComponentSpec {
        mass_per_length_kg_per_m,
        joints: Some(ToolJoints { od_m: 0.168275, spacing_m }),
        ..spec
    };
    let metres = ComponentLength::Metres;
    let heavy = tool("heavy-weight drill pipe", metres(93.0), 0.127, 0.0762);
    let pipe = tool("drill pipe", ComponentLength::ToSurface, 0.127, 0.10861);
    let components = vec![
        tool("bit", metres(0.3), 0.2159, 0.0),
        tool("drill collars", metres(55.0), 0.1651, 0.0714375),
        jointed(heavy, 74.76, 9.3),
        jointed(pipe, 32.135, 9.6),
    ];
    model(path, hole, components, Mud { drag_coefficient: 1.0, ..mud(1100.0) }, 1200.0)
}

/// Friction feeds an axial vibration of 6 Hz through the bending of the pipe between its joints:
/// its amplitude grows as fast on elements of 1.6, 0.8 and 0.4 m, by 0.28/s, and saturates at
/// 20 kN. Elements from joint to joint leave the bending out.
#[test]
fn a_steady_trip_that_swings_is_reported() {
    let model = slant();
    let operation = operation(TripOut, 1200.0).trip_speed_m_per_s(0.3);
    let swings = |mesh: MeshSettings| -> Option<Check> {
        let settings =
            DynamicsSettings { mesh, settle_s: 40.0, duration_s: 10.0, ..Default::default() };
        let mut simulation = Simulation::new(&model, &operation, &settings).expect("a string");
        simulation.advance(50.0).expect("it runs");
        let outcome = simulation.outcome();
        let checks = Judge::default().dynamic(&model, &operation, &settings, &(&outcome).into());
        only(&checks.checks, CheckKind::HookLoadSwings)
    };
    let check = swings(MeshSettings::uniform(3.2)).expect("it swings");
    assert_eq!(check.severity, Severity::Warning);
    let [swing_N, limit_N] = [check.value, check.limit].map(|value| value.expect("a number"));
    assert!(swing_N > 3.0 * limit_N && swing_N < 30e3, "{check:?}");
    assert!(check.sentence.contains("swings by ±"), "{}", check.sentence);
    assert_eq!(swings(MeshSettings::default()), None);
}
