//! A run that is written to a checkpoint and resumed ends with the same bits.

use wholestring::{
    dynamics::{
        BitLaw, BitSettings, BitTable, Checkpoint, DynamicOutcome, Excitation, FrictionLaw,
        MeshSettings, Motor, Precision, ResumeError, Simulation, Start, TableLaw, TablePoint,
        UntilSteady,
    },
    ends::{BitEnd, Ends, TopEnd},
    operation::OperationKind,
};

use crate::{
    common::{MOTOR, SMOOTH},
    wells::{Case, each, go, moderate, np13, np13_eccentric},
};

/// Drilling with the autodriller, tripping with the independent law from a centred start, sliding
/// with the motor, drilling with an eccentric string in single precision, drilling by a table with
/// noise, a motor that yields and side cutting, tripping out with a pull on a clamped bit under a
/// pinned top: every state variable of a run changes in one of them.
fn cases() -> [Case; 6] {
    let mut trip = moderate(OperationKind::TripIn, 0.3);
    trip.settings.friction_law = FrictionLaw::Independent;
    trip.settings.start = Start::Centred;
    let mut single = np13_eccentric(0.3);
    single.settings.precision = Precision::Single;
    let slide = moderate(OperationKind::Slide, 0.3);
    let mut measured = moderate(OperationKind::Drill, 0.3);
    measured.settings.bit = measured_bit();
    measured.operation.flow_rate_m3_per_s = 30e-3;
    measured.operation = measured.settings.bit.drilling_steadily(measured.operation);
    let mut pulled = moderate(OperationKind::TripOut, 0.3);
    pulled.operation.bit_pull_N = 50e3;
    pulled.model.ends = Ends { top: TopEnd::Pinned, bit: BitEnd::Clamped };
    let mut cases = [np13(0.3), trip, slide, single, measured, pulled];
    for case in &mut cases {
        case.lasts(1.5, 1.5);
    }
    cases
}

fn measured_bit() -> BitSettings {
    let point = |weight_on_bit_N: f64| TablePoint {
        weight_on_bit_N,
        rotary_speed_rad_per_s: 20.0,
        rate_of_penetration_m_per_s: 1e-7 * weight_on_bit_N,
        torque_N_m: 0.05 * weight_on_bit_N,
        torque_std_N_m: Some(300.0),
        weight_on_bit_std_N: Some(2e3),
    };
    BitSettings {
        law: BitLaw::Table(TableLaw {
            table: BitTable::new(&[point(20e3), point(60e3)]).expect("a table"),
            rock_stiffness_N_per_m: 1e8,
            excitation: Some(Excitation { amplitude_m: 0.1e-3, ..SMOOTH }),
        }),
        steerability: 0.05,
        motor: Motor::Displacement(MOTOR),
        ..BitSettings::default()
    }
}

/// When the runs stop: before the window, at its border, within it, and at its end.
const STOPS_S: [f64; 5] = [0.7, 1.5, 2.1, 2.2, 3.0];

/// The run of a case; `stopped` receives it at each stop and returns the run that continues.
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

/// A run that settles until it is steady, in pieces of so long; `stopped` receives it after each
/// and returns the run that continues.
fn settled(
    case: &Case,
    piece_s: f64,
    stopped: impl Fn(Simulation) -> Simulation,
) -> DynamicOutcome {
    let mut simulation = case.start();
    loop {
        let left_s = simulation.end_time_s() - simulation.time_s();
        if left_s < 0.5 * simulation.sample_interval_s() {
            return simulation.outcome();
        }
        go(&mut simulation, left_s.min(piece_s));
        simulation = stopped(simulation);
    }
}

/// Written to a checkpoint while it settles, again and again, a run begins its window with the same
/// sample, in either precision.
#[test]
fn a_run_taken_up_again_settles_at_the_same_sample() {
    let cases = [Precision::Double, Precision::Single].map(|precision| {
        let mut case = moderate(OperationKind::Drill, 0.3);
        case.settings.precision = precision;
        case.settings.settle_s = 0.0;
        case.settings.steady = Some(UntilSteady { max_s: 40.0 });
        // No piece is longer than the window, which may begin within one.
        case.settings.duration_s = 4.0;
        case
    });
    for [straight, resumed] in each(&cases, |case| {
        let straight = settled(case, 1.7, |simulation| simulation);
        let resumed = settled(case, 3.1, |simulation| {
            let bytes = postcard::to_allocvec(&simulation.checkpoint()).unwrap();
            let checkpoint: Checkpoint = postcard::from_bytes(&bytes).unwrap();
            drop(simulation);
            Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint).unwrap()
        });
        [straight, resumed]
    }) {
        // It was written to a checkpoint before the window: that begins after the damping of the
        // start and a stretch, 10 s, at the earliest.
        let settle_s = straight.numerics.settle_s;
        assert!(settle_s > 10.0, "{settle_s}");
        assert_eq!(straight.numerics.settled, Some(true), "{settle_s}");
        let end_s = straight.series.time_s.last().copied().unwrap();
        assert!((end_s - settle_s - 4.0).abs() < 0.02, "{settle_s} to {end_s}");
        assert!(straight == resumed);
    }
}

#[test]
fn a_checkpoint_of_another_string_is_refused() {
    let mut case = moderate(OperationKind::TripIn, 0.3);
    let checkpoint = case.start().checkpoint().into_owned();
    let found = case.start().mesh().nodes.len();
    case.settings.mesh = MeshSettings::uniform(6.4);
    let expected = case.start().mesh().nodes.len();
    let error = Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint);
    assert_eq!(error.unwrap_err(), ResumeError::AnotherString { found, expected });
}

#[test]
fn a_checkpoint_of_another_precision_is_refused() {
    let mut case = moderate(OperationKind::Drill, 0.3);
    let checkpoint = case.start().checkpoint().into_owned();
    case.settings.precision = Precision::Single;
    let error = Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint);
    assert_eq!(error.unwrap_err(), ResumeError::AnotherPrecision);
}
