//! Elements that are too long for a compression higher than that assumed for the mesh.

use std::{num::NonZeroUsize, path::Path, sync::Arc};

use wholestring::dynamics::{HoistSetPoint, ScheduleStep};
use wholestring_case::{Case, Override};
use wholestring_runner::{CancellationToken, Error, Silent, run, run::Live};

/// 250 m of drill pipe in a level hole, pushed by heavy-weight pipe above it. Its lowest joint,
/// which reaches to the bit, is an element of 9.9 m and buckles under 129.3 kN, `π² EI/L²` of 5 in
/// pipe of 4.276 in inside.
const LATERAL: &str = r#"
model = "dynamic"
[well]
path = "minimum-curvature"
stations = [[0, 0, 0], [350, 0, 0], [530, 90, 0], [760, 90, 0]]
[[well.hole]]
kind = "open"
to = 760
diameter = "8.5 in"
friction = 0.2
[mud]
density = "1.1 sg"
[[string]]
component = "bit"
od = "8.5 in"
length = "0.3 m"
[[string]]
component = "drill pipe"
catalogue = "5 in 19.50 lb/ft G-105"
length = "250 m"
[[string]]
component = "hwdp"
catalogue = "HWDP 5 in 49.3 lb/ft"
length = "to surface"
[bit]
torque = "2.5 kN.m"
[operation]
kind = "drill"
rpm = 60
wob = "30 kN"
rop = "20 m/h"
bit_depth = "750 m"
[dynamics]
settle = "14 s"
duration = "5 s"
"#;

fn case(changes: &[&str]) -> Arc<Case> {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("lateral.toml");
    std::fs::write(&file, LATERAL).expect("it is written");
    let changes: Vec<Override> =
        changes.iter().map(|change| change.parse().expect("an override")).collect();
    Arc::new(wholestring_case::load(Path::new(&file), &changes).expect("a valid case"))
}

fn begin(case: &Arc<Case>) -> Live {
    let laws = run::OwnLaws::default();
    let jobs = NonZeroUsize::new(1);
    Live::begin(case.clone(), None, &laws, jobs, &Silent, &CancellationToken::new()).expect("a run")
}

fn advance(live: &mut Live, seconds: f64) -> Result<(), Error> {
    live.advance(seconds, &Silent, &CancellationToken::new())
}

fn set(hoist: HoistSetPoint) -> ScheduleStep {
    ScheduleStep { hoist: Some(hoist), ..ScheduleStep::default() }
}

/// A manual weight above the buckling load of elements between joints is refused, with the length
/// that would carry it; a lower weight, or the same with a mesh made for it, is accepted.
#[test]
fn a_weight_that_folds_the_mesh_is_refused() {
    let mut live = begin(&case(&[]));
    let refused =
        live.add_to_schedule(set(HoistSetPoint::WeightOnBit(180e3))).expect_err("refused");
    let message = refused.to_string();
    for part in [
        "a weight on bit of 180 kN exceeds what the mesh is made for: the element of 9.9 m at",
        "its own buckling load is 129.3 kN",
        "mesh.element_length = \"4",
    ] {
        assert!(message.contains(part), "{part}: {message}");
    }
    live.add_to_schedule(set(HoistSetPoint::WeightOnBit(60e3))).expect("a lighter weight");
    let mut finer = begin(&case(&["mesh.element_length=2.4m"]));
    finer.add_to_schedule(set(HoistSetPoint::WeightOnBit(180e3))).expect("shorter elements");
    let mut foreseen = begin(&case(&["operation.schedule=[{ at = 60, wob = \"180 kN\" }]"]));
    foreseen.add_to_schedule(set(HoistSetPoint::WeightOnBit(180e3))).expect("a mesh for it");
}

/// A block that is lowered manually pushes until an element buckles: the run stops, names the
/// element, and does not continue.
#[test]
fn a_run_whose_elements_buckle_stops() {
    let mut live = begin(&case(&[]));
    live.add_to_schedule(set(HoistSetPoint::BlockVelocity(0.06))).expect("it is taken");
    let stopped = advance(&mut live, 20.0).expect_err("it stops").to_string();
    assert!(stopped.contains("buckles between its nodes under a compression of"), "{stopped}");
    assert!(stopped.contains("mesh.element_length = \""), "{stopped}");
    let at_s = live.simulation().time_s();
    assert!(at_s < 19.0, "{at_s}");
    assert_eq!(advance(&mut live, 1.0).expect_err("it stands").to_string(), stopped);
    assert_eq!(live.simulation().time_s(), at_s);
}

/// A weight that the schedule raises sixfold reaches the bit. With a mesh made for the first weight
/// the string folds, and two thirds of it reach the bit.
#[test]
fn a_weight_that_the_schedule_raises_reaches_the_bit() {
    let case = case(&["operation.schedule=[{ at = 3, ramp = 5, wob = \"180 kN\" }]"]);
    let token = CancellationToken::new();
    let solved = run::answer(&case, None, &Silent, &token).expect("a run");
    let answer = &solved.answers.summary().operations[0];
    let kinds: Vec<&str> = answer.checks.iter().map(|check| check.kind.name()).collect();
    assert!(!kinds.contains(&"element_buckles"), "{kinds:?}");
    let weight_N = answer.scalars.weight_on_bit_N;
    assert!((weight_N / 180e3 - 1.0).abs() < 0.05, "{weight_N}");
}
