//! Collars that bow under their weight on bit in a vertical hole.

use wholestring::{
    operation::OperationKind::Drill,
    prelude::*,
    statics::{
        assembly::{self, AssemblySettings},
        stiff::{self, StiffSettings},
    },
};
use wholestring_judge::{CheckKind, Checks, Disturbed, Judge, Severity};

use crate::{
    common::{arcs, model, mud, open_hole, pressing, rpm, steel},
    judged::{none, only},
};

/// 110 m of collars below 5 in drill pipe in a straight well of 300 m of an inclination, deg.
fn well(inclination_deg: f64) -> Model {
    let path = arcs(&[[0.0, inclination_deg, 0.0], [300.0, inclination_deg, 0.0]]);
    let tool = |name, length, od_m, id_m| ComponentSpec::uniform(name, od_m, id_m, length, steel());
    let components = vec![
        tool("bit", Metres(0.3), 0.2159, 0.0),
        tool("drill collars", Metres(110.0), 0.1651, 0.0714375),
        tool("drill pipe", ToSurface, 0.127, 0.1086),
    ];
    model(path, open_hole(0.2159, 0.3, 300.0), components, mud(1100.0), 300.0)
}

const fn disturbed(keeps_its_shape: bool, leaves_its_tool_face: bool) -> Disturbed {
    Disturbed { keeps_its_shape, leaves_its_tool_face }
}

fn drills(weight_on_bit_N: f64) -> Operation {
    pressing(Drill, 300.0, weight_on_bit_N).rotary_speed_rad_per_s(rpm(90.0))
}

/// In a vertical hole the string bows as soon as the collars press on the bit by more than
/// Lubinski's first load, 42 kN, and turning it rolls up the wall: every solver that finds that
/// reports a note.
#[test]
fn a_bow_in_a_vertical_hole_is_a_note() {
    let (model, operation) = (well(0.0), drills(58.8e3));
    let judge = Judge::default();
    let is_noted = |checks: &Checks, solver: &str| {
        let check = only(&checks.checks, CheckKind::UnstableEquilibrium);
        let check = check.unwrap_or_else(|| panic!("{solver}: {:?}", checks.checks));
        assert_eq!(check.severity, Severity::Note, "{solver}");
        assert!(check.sentence.contains("compressed in a vertical hole"), "{}", check.sentence);
    };
    let stiff = stiff::solve(&model, &operation, &StiffSettings::default()).expect("a state");
    is_noted(&judge.stiff(&model, &operation, &stiff), "stiff string");
    let state = assembly::solve(&model, &operation, &AssemblySettings::default());
    let state = state.expect("a state");
    let soft = soft_string(&model, &operation);
    is_noted(&judge.assembly(&model, &operation, &state, &soft), "static BHA analysis");
    let soft = soft.expect("a profile");
    is_noted(&judge.small_motions(&model, &operation, &soft, disturbed(false, false)), "vibration");
}

/// An unstable equilibrium for another reason than a bow in a vertical hole is a warning.
#[test]
fn another_unstable_equilibrium_is_a_warning() {
    for (inclination_deg, weight_N) in [(30.0, 58.8e3), (0.0, 10e3)] {
        let (model, operation) = (well(inclination_deg), drills(weight_N));
        let soft = soft_string(&model, &operation).expect("a profile");
        let judge = Judge::default();
        let checks = judge.small_motions(&model, &operation, &soft, disturbed(false, false));
        let check = only(&checks.checks, CheckKind::UnstableEquilibrium).expect("a check");
        assert_eq!(check.severity, Severity::Warning, "{inclination_deg} deg");
        let stable = judge.small_motions(&model, &operation, &soft, disturbed(true, false));
        none(&stable.checks, CheckKind::UnstableEquilibrium);
    }
}

/// A tool face that the string would leave is a warning of its own, whether or not the string
/// otherwise stays where it is.
#[test]
fn a_tool_face_that_the_string_leaves_is_a_warning() {
    let (model, operation) = (well(30.0), drills(58.8e3));
    let soft = soft_string(&model, &operation).expect("a profile");
    let judge = Judge::default();
    for (keeps_its_shape, expected) in [(true, 1), (false, 2)] {
        let checks =
            judge.small_motions(&model, &operation, &soft, disturbed(keeps_its_shape, true));
        let checks: Vec<_> = checks.checks.iter().map(|one| (one.severity, one.kind)).collect();
        assert_eq!(checks, vec![(Severity::Warning, CheckKind::UnstableEquilibrium); expected]);
    }
    let checks = judge.small_motions(&model, &operation, &soft, disturbed(true, true)).checks;
    let sentence = &checks[0].sentence;
    assert!(sentence.contains("tool face") && sentence.contains("mode 1"), "{sentence}");
}
