//! A string at rest keeps its drag.

use wholestring::{dynamics::HoistControl, operation::OperationKind};

use crate::wells::{between, go, np13};

/// A string that was lowered with friction hangs on its wall when the block stops: the load on the
/// wall at that time is permanent. From 10 to 60 s after the stop the hook load moves by less than
/// 0.1 kN.
///
/// Expected: no drift at all, because Coulomb's static friction holds any load up to its limit. 0.1
/// kN is a tenth of what weight indicators show; a law that creeps loses all of the drag, 270 kN
/// here. Found: 0.02 kN, the last of the axial ringing.
#[test]
fn a_stopped_string_keeps_its_hook_load() {
    let mut case = np13(0.3);
    case.operation.kind = OperationKind::TripIn;
    let mut simulation = case.start();
    go(&mut simulation, 10.0);
    let stop_s = simulation.time_s();
    simulation.set_hoist(HoistControl::BlockVelocity(0.0));
    go(&mut simulation, 61.0);
    let outcome = simulation.outcome();
    let series = &outcome.series;
    let held = between(&series.time_s, &series.hook_load_N, stop_s + 10.0, stop_s + 60.0);
    let (low, high) = held.iter().fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(*x), h.max(*x)));
    let friction = between(&series.time_s, &series.axial_friction_N, stop_s + 10.0, stop_s + 60.0);
    assert!(high - low < 100.0, "hook load between {low} and {high} N");
    // It was lowered against friction, and that has not been lost.
    assert!(friction.iter().all(|f| *f < -100e3), "the wall carries {} N", friction[0]);
}
