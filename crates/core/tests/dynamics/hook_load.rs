//! A constant lift that is found for a mean weight on bit.

use std::sync::Arc;

use wholestring::{
    dynamics::{FrictionLaw, HoistControl, Start, TuningError, WEIGHT_TOLERANCE, tune_hook_load},
    operation::{Operation, OperationKind},
    rock::{Alone, Executor},
};

use crate::{
    common::{assert_close, operation},
    wells::{Case, STRAIGHT_DEG, mud, straight},
};

const LENGTH_M: f64 = 600.0;
const WEIGHT_N: f64 = 20e3;

/// Nobody to help.
fn alone() -> Arc<dyn Executor + Send + Sync> {
    Arc::new(Alone)
}

/// A straight hole, drilled for 5 s after 2 s.
fn drilling(mu: f64) -> Case {
    let drill = operation(OperationKind::Drill, LENGTH_M)
        .weight_on_bit_N(WEIGHT_N)
        .rate_of_penetration_m_per_s(10.0 / 3600.0);
    let mut case = Case::new(straight(LENGTH_M, mu), drill);
    case.lasts(2.0, 5.0);
    case
}

/// Without friction lift and weight on bit carry the string between them, `F + W = w L cos i`.
///
/// Within 0.1 % of the string's weight: the remainder of the momentum from the start, over the
/// window.
#[test]
fn without_friction_it_is_the_weight_that_the_bit_does_not_bear() {
    let case = drilling(0.0);
    let (lift, _) =
        tune_hook_load(&case.model, &case.operation, &case.settings, &alone(), |_, _| true)
            .unwrap_or_else(|error| panic!("{error}"));
    let pipe = &case.model.string.components()[0];
    let hanging = LENGTH_M
        * pipe.buoyed_weight_per_length_N_per_m(mud().density_kg_per_m3)
        * STRAIGHT_DEG.to_radians().cos();
    assert_close("lift and weight on bit", lift.hook_load_N + lift.weight_on_bit_N, hanging, 1e-3);
    assert_close("weight on bit", lift.weight_on_bit_N, WEIGHT_N, WEIGHT_TOLERANCE);
}

/// Where friction holds the string against its lift the weight does not follow it one for one, and
/// has to be searched. The result holds for a run with that lift to the last bit, and the finished
/// run is returned with it.
#[test]
fn with_friction_it_is_found_and_holds() {
    let mut case = drilling(0.3);
    case.settings.start = Start::Centred;
    case.settings.settle_s = 0.0;
    case.settings.friction_law = FrictionLaw::Independent;
    let mut tries = Vec::new();
    let (lift, simulation) =
        tune_hook_load(&case.model, &case.operation, &case.settings, &alone(), |run, _| {
            if tries.last() != Some(&run) {
                tries.push(run);
            }
            true
        })
        .unwrap_or_else(|error| panic!("{error}"));
    assert_close("weight on bit", lift.weight_on_bit_N, WEIGHT_N, WEIGHT_TOLERANCE);
    assert_eq!(tries, (1..=lift.runs).collect::<Vec<_>>());
    case.settings.hoist_control = Some(HoistControl::HookLoad(lift.hook_load_N));
    let (found, again) = (simulation.outcome().scalars, case.run().scalars);
    assert_eq!(found.weight_on_bit_N.to_bits(), again.weight_on_bit_N.to_bits());
    assert_eq!(lift.weight_on_bit_N.to_bits(), again.weight_on_bit_N.to_bits());
}

/// Nothing to tune for, a weight that the string does not have, and a stop request.
#[test]
fn what_cannot_be_tuned_says_so() {
    let case = drilling(0.0);
    let off = operation(OperationKind::RotateOffBottom, LENGTH_M);
    let tuned = |operation: &Operation, goes_on: bool| {
        tune_hook_load(&case.model, operation, &case.settings, &alone(), |_, _| goes_on)
            .map(|(lift, _)| lift)
    };
    assert!(matches!(tuned(&off, true), Err(TuningError::NoWeight("rotate_off_bottom"))));
    assert!(matches!(tuned(&case.operation, false), Err(TuningError::Stopped)));
    let heavy = case.operation.weight_on_bit_N(1e6);
    match tuned(&heavy, true) {
        Err(error @ TuningError::NotFound { .. }) => {
            let message = error.to_string();
            assert!(message.contains("1000.0 kN") && message.contains("20 runs"), "{message}");
        }
        other => panic!("{other:?}"),
    }
}
