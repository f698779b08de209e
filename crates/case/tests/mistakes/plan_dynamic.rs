//! Mistakes in `[plan.dynamic]`, and in the gel strength that it uses.

use wholestring::operation::OperationKind;
use wholestring_plan::{
    FrictionLevel,
    dynamic::{DynamicPlan, Event},
};

use crate::{
    common::{change::rows, changed, read},
    each_warned,
    plan::{accepted, planned},
    refused,
};

/// The example with a mud that flows, and pumps.
fn flowing(text: &str) -> String {
    text.replace(
        "density = \"1.2 sg\"",
        "density = \"1.2 sg\"\nrheology = \"newtonian\"\nviscosity = \"20 cP\"\ngel_strength = \"12 Pa\"",
    )
    .replace("rpm = 70", "rpm = 70\nflow_rate = \"2000 L/min\"")
}

#[test]
fn events_and_wear() {
    let cases = rows(
        r#"
        plan_dynamic_empty: `dynamic = {}`
        plan_dynamic_event_unknown: `dynamic = { events = "pick_up" }`
        plan_dynamic_event_twice: `dynamic = { events = ["break_rotation", "break_rotation"] }`
        plan_dynamic_events_as_number: `dynamic = { events = 2 }`
        plan_dynamic_depth_beyond_the_hole: `dynamic = { events = "break_rotation", bit_depths = "5000 m" }`
        plan_dynamic_depth_twice: `dynamic = { events = "break_rotation", bit_depths = [900, 900] }`
        plan_dynamic_friction_unknown: `dynamic = { events = "break_rotation", friction = "medium" }`
        plan_dynamic_friction_twice: `dynamic = { events = "break_rotation", friction = ["low", "low"] }`
        plan_dynamic_ramp_without_unit: `dynamic = { events = "break_rotation", rotary_ramp = "5" }`
        plan_dynamic_hoist_ramp_as_speed: `dynamic = { events = "pick_up_from_slips", hoist_ramp = "0.3 m/s" }`
        plan_dynamic_pump_ramp_negative: `dynamic = { events = "break_rotation", pump_ramp = -1 }`
        plan_dynamic_watch_of_nothing: `dynamic = { events = "break_rotation", watch = 0 }`
        plan_dynamic_circulation_without_flow: `dynamic = { events = "break_circulation" }`
        plan_dynamic_wears_by_trips: `dynamic = { wear = "trip_out" }`
        plan_dynamic_wear_unknown: `dynamic = { wear = "milling" }`
        plan_dynamic_wear_twice: `dynamic = { wear = ["drill", "drilling"] }`
        plan_dynamic_turns_for_no_time: `dynamic = { wear = "rotate_off_bottom" }`
        plan_dynamic_wears_by_what_is_not_planned: `operations = "trip_in"\ndynamic = { wear = "drill" }`
        plan_dynamic_key_misspelt: `dynamic = { event = "break_rotation" }`
        "#,
    );
    for (name, keys) in cases {
        refused(name, read(&planned(&keys)));
    }
    let flows = planned("dynamic = { events = \"break_circulation\" }")
        .replace("rpm = 70", "rpm = 70\nflow_rate = \"2000 L/min\"");
    refused("plan_dynamic_circulation_without_rheology", read(&flows));
    for (name, value) in [
        ("gel_strength_without_unit", "\"12\""),
        ("gel_strength_as_viscosity", "\"20 cP\""),
        ("gel_strength_negative", "-1"),
    ] {
        let with_gel = format!("density = \"1.2 sg\"\ngel_strength = {value}");
        refused(name, read(&changed("density = \"1.2 sg\"", &with_gel)));
    }
    each_warned(
        r#"
        warn_plan_dynamic_ramps_of_other_events: `[mesh]`
            -> `[plan]\ndynamic = { events = "break_rotation", hoist_ramp = "1 s", pump_ramp = "5 s" }\n[mesh]`
        warn_plan_dynamic_events_keys_of_wear: `[mesh]`
            -> `[plan]\ndynamic = { wear = "drill", rotary_ramp = "1 s", watch = "9 s", friction = "low" }\n[mesh]`
        "#,
    );
}

#[test]
fn nothing_is_asked_where_nothing_is_said() {
    assert_eq!(accepted("").plan.dynamic, DynamicPlan::default());
    assert!(DynamicPlan::default().tasks().is_empty());
}

#[test]
fn what_is_given_is_asked() {
    let text = planned(
        "bit_depths = [900, 2000, 4305]\ncampaign = { off_bottom = \"10 h\" }\n\
         dynamic = { events = [\"pick_up_from_slips\", \"break_circulation\"], wear = [\"drill\", \"rotate_off_bottom\"], \
         bit_depths = [4000, 900], friction = [\"low\", \"high\"], hoist_ramp = \"1 s\", pump_ramp = \"30 s\", \
         watch = \"12 s\" }",
    );
    let case = read(&flowing(&text)).unwrap_or_else(|report| panic!("{report}"));
    let dynamic = &case.plan.dynamic;
    assert_eq!(dynamic.events, [Event::PickUpFromSlips, Event::BreakCirculation]);
    assert_eq!(dynamic.bit_depths_m, [900.0, 4000.0]);
    assert_eq!(dynamic.frictions, [FrictionLevel::Low, FrictionLevel::High]);
    assert_eq!(dynamic.tasks().len(), 8);
    let ramps = Event::ALL.map(|event| dynamic.ramp_s(event));
    assert_eq!(ramps, [1.0, 1.0, 30.0, 5.0]);
    assert_eq!((dynamic.watch_s, dynamic.gel_strength_Pa), (12.0, Some(12.0)));
    let set = dynamic.set_points.expect("set points");
    assert!((set.flow_rate_m3_per_s - 2.0 / 60.0).abs() < 1e-12);
    assert!(set.rotary_speed_rad_per_s > 7.0);
    let kinds: Vec<_> = dynamic.wear.iter().map(|wear| wear.kind).collect();
    assert_eq!(kinds, [OperationKind::Drill, OperationKind::RotateOffBottom]);
    // Drilling at both depths, turning off bottom where the campaign does: the deepest is nearest
    // to 4000 m.
    let broomstick = case.broomstick().expect("a broomstick");
    let tasks = dynamic.wear_tasks(broomstick.campaign().expect("a campaign"));
    let tasks = tasks.iter().map(|task| (task.operation.kind, task.operation.bit_depth_m));
    let tasks: Vec<_> = tasks.collect();
    assert!(tasks.contains(&(OperationKind::RotateOffBottom, 4000.0)), "{tasks:?}");
    assert!(!tasks.contains(&(OperationKind::RotateOffBottom, 900.0)), "{tasks:?}");
    assert!(tasks.contains(&(OperationKind::Drill, 4000.0)), "{tasks:?}");
}
