//! Mistakes in `[plan]`.

use wholestring::operation::OperationKind;
use wholestring_case::Case;
use wholestring_plan::{FrictionLevel, Statics};

use crate::{
    common::{change::rows, changed, read},
    each_warned, refused, warned,
};

/// The example with a plan.
pub(crate) fn planned(keys: &str) -> String {
    changed("[mesh]", &format!("[plan]\n{keys}\n[mesh]"))
}

pub(crate) fn accepted(keys: &str) -> Case {
    read(&planned(keys)).unwrap_or_else(|report| panic!("{keys}\n{report}"))
}

/// Coiled tubing from an injector head, in an operation; without one of the head's keys it is pipe.
fn coiled_tubing([operation, rotation, push]: [&str; 3]) -> String {
    changed("catalogue = \"5-1/2 in 21.90 lb/ft S-135\"", "od = \"60.3 mm\"\nid = \"50.7 mm\"")
        .replace("kind = \"drill\"", &format!("kind = \"{operation}\""))
        .replace("rpm = 70", rotation)
        .replace("[rig] ", &format!("[rig]\n{push}\n#"))
}

#[test]
fn coiled_tubing_does_not_rotate() {
    use OperationKind::{RotateOffBottom, Slide, TripIn, TripOut};
    let planned = |push: &str| {
        let case =
            read(&coiled_tubing(["slide", "#", push])).unwrap_or_else(|report| panic!("{report}"));
        case.plan.operations.iter().map(|one| one.kind).collect::<Vec<_>>()
    };
    assert_eq!(planned("snubbing_force = \"200 kN\""), [TripOut, TripIn, Slide]);
    assert_eq!(planned(""), [TripOut, TripIn, RotateOffBottom, Slide]);
    let rotated = ["rotate_off_bottom", "rpm = 70", "snubbing_force = \"200 kN\""];
    warned("warn_coiled_tubing_rotates", read(&coiled_tubing(rotated)));
}

#[test]
fn plans() {
    let cases = rows(
        r#"
        plan_friction_low_above_high: `friction = { low = 0.4, expected = 0.3, high = 0.2 }`
        plan_friction_low_above_own: `friction = { low = 0.35 }`
        plan_friction_high_below_own: `friction = { high = { open = 0.2 } }`
        plan_friction_around_above: `friction = { low = { open = { kinetic = 0.2, around = 0.5 } } }`
        plan_friction_out_of_range: `friction = { high = 3 }`
        plan_friction_as_text: `friction = { low = "0.2" }`
        plan_friction_as_list: `friction = [0.2, 0.3, 0.4]`
        plan_friction_kind_unknown: `friction = { low = { casing = 0.2 } }`
        plan_friction_level_unknown: `friction = { medium = 0.2 }`
        plan_depths_one: `depths = 1`
        plan_depths_as_length: `depths = "30 m"`
        plan_depth_beyond_the_hole: `bit_depths = ["1000 m", "5000 m"]`
        plan_depth_above_the_assembly: `bit_depths = ["0.2 m"]`
        plan_depth_twice: `bit_depths = ["1000 m", "1000 m"]`
        plan_depths_empty: `bit_depths = []`
        plan_shallowest_at_the_bit: `shallowest = "4305 m"`
        plan_shallowest_above_the_assembly: `shallowest = "0.3 m"`
        plan_operation_unknown: `operations = "pulling"`
        plan_operation_twice: `operations = ["trip_out", "pick-up"]`
        plan_operation_without_set_points: `operations = ["trip_out", "slide"]`
        plan_model_dynamic: `models = "dynamic"`
        plan_model_twice: `models = ["soft", "soft"]`
        plan_key_misspelt: `dephts = 20`
        "#,
    );
    for (name, keys) in cases {
        refused(name, read(&planned(&keys)));
    }
    let still = planned("operations = [\"trip_in\", \"ream\"]")
        .replace("kind = \"drill\"", "kind = \"trip_out\"")
        .replace("rpm = 70", "#");
    refused("plan_reams_without_rpm", read(&still));
    each_warned(
        r#"
        warn_plan_depths_twice: `[mesh]`
            -> `[plan]\ndepths = 12\nshallowest = "500 m"\nbit_depths = ["900 m", "4305 m"]\n[mesh]`
        "#,
    );
}

#[test]
fn a_case_without_a_plan_has_one() {
    let plan = accepted("").plan;
    let names: Vec<&str> = plan.operations.iter().map(|operation| operation.kind.name()).collect();
    assert_eq!(names, ["trip_out", "trip_in", "rotate_off_bottom", "drill"]);
    assert_eq!(plan.models, [Statics::Soft]);
    // Thirty evenly, one of them the case's, and the casing shoe.
    assert_eq!(plan.bit_depths_m.len(), 31);
    assert_eq!(plan.bit_depths_m.last(), Some(&4305.0));
    assert!(plan.bit_depths_m.contains(&2986.53));
    assert!((plan.bit_depths_m[0] - 1.34).abs() < 1e-9);
}

#[test]
fn plans_say_what_they_mean() {
    let case = accepted(
        "friction = { expected = { cased = 0.25 }, high = { cased = 0.3, open = { kinetic = 0.5, around = 0.4 } } }\n\
         bit_depths = [\"4305 m\", \"900 m\", \"3000 m\"]\n\
         operations = [\"pick-up\", \"ream\", \"drilling\"]\nmodels = [\"soft\", \"stiff\"]",
    );
    let kinds: Vec<OperationKind> =
        case.plan.operations.iter().map(|operation| operation.kind).collect();
    assert_eq!(kinds, [OperationKind::TripOut, OperationKind::Ream, OperationKind::Drill]);
    assert_eq!(case.plan.bit_depths_m, [900.0, 3000.0, 4305.0]);
    let broomstick = case.broomstick().expect("sound frictions");
    assert_eq!(broomstick.tasks().len(), 2 * 3 * 3);
    let round = |number: f64| (1e9 * number).round() / 1e9;
    let frictions = FrictionLevel::ALL.map(|level| {
        let sections = broomstick.setup(level).well.hole.sections();
        [round(sections[0].friction.kinetic), round(sections[1].friction.kinetic)]
    });
    assert_eq!(frictions, [[0.15, 0.2], [0.25, 0.3], [0.3, 0.5]]);
    // Off bottom a case without a rotary speed turns with the usual one.
    let still =
        planned("").replace("kind = \"drill\"", "kind = \"trip_out\"").replace("rpm = 70", "#");
    let plan = read(&still).expect("a valid case").plan;
    assert!((plan.operations[2].rotary_speed_rad_per_s - std::f64::consts::TAU).abs() < 1e-12);
}
