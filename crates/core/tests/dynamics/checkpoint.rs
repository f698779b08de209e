//! A run that is laid aside and taken up again ends with the same bits.

use wholestring::{
    dynamics::{
        Checkpoint, DynamicOutcome, FrictionLaw, Precision, ResumeError, Simulation, Start,
    },
    operation::OperationKind,
};

use crate::wells::{Case, each, go, moderate, np13};

/// Drilling with the autodriller, tripping with the independent law from a centred start, sliding with
/// the motor, drilling in single precision: what changes in a run changes in one of them.
fn cases() -> [Case; 4] {
    let mut trip = moderate(OperationKind::TripIn, 0.3);
    trip.settings.friction_law = FrictionLaw::Independent;
    trip.settings.start = Start::Centred;
    let mut single = np13(0.3);
    single.settings.precision = Precision::Single;
    let slide = moderate(OperationKind::Slide, 0.3);
    let mut cases = [np13(0.3), trip, slide, single];
    for case in &mut cases {
        case.settings.settle_s = 1.5;
        case.settings.duration_s = 1.5;
    }
    cases
}

/// When the runs stop: before the window, at its border, within it, and at its end.
const STOPS_S: [f64; 5] = [0.7, 1.5, 2.1, 2.2, 3.0];

/// The run of a case; `stopped` gets it at each stop and gives back what goes on.
fn run(case: &Case, stopped: impl Fn(Simulation) -> Simulation) -> DynamicOutcome {
    let mut simulation = case.start();
    for stop_s in STOPS_S {
        let left_s = stop_s - simulation.time_s();
        go(&mut simulation, left_s);
        simulation = stopped(simulation);
    }
    simulation.outcome()
}

/// Written to bytes, dropped, and read back, again and again.
#[test]
fn a_run_taken_up_again_ends_with_the_same_bits() {
    for [straight, resumed] in each(&cases(), |case| {
        let resumed = run(case, |simulation| {
            let bytes = postcard::to_allocvec(&simulation.checkpoint()).unwrap();
            let checkpoint: Checkpoint = postcard::from_bytes(&bytes).unwrap();
            assert_eq!(checkpoint.time_s(), simulation.time_s());
            drop(simulation);
            Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint).unwrap()
        });
        [run(case, |simulation| simulation), resumed]
    }) {
        // Their numbers fill pages.
        assert!(straight == resumed);
    }
}

#[test]
fn a_checkpoint_of_another_string_is_refused() {
    let mut case = moderate(OperationKind::TripIn, 0.3);
    let checkpoint = case.start().checkpoint().into_owned();
    let found = case.start().mesh().nodes.len();
    case.settings.element_length_m *= 2.0;
    let expected = case.start().mesh().nodes.len();
    let error = Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint);
    assert_eq!(
        error.unwrap_err(),
        ResumeError::AnotherString { found, expected }
    );
}

#[test]
fn a_checkpoint_of_another_precision_is_refused() {
    let mut case = moderate(OperationKind::Drill, 0.3);
    let checkpoint = case.start().checkpoint().into_owned();
    case.settings.precision = Precision::Single;
    let error = Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint);
    assert_eq!(error.unwrap_err(), ResumeError::AnotherPrecision);
}
