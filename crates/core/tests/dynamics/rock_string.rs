//! A string that drills solid rock.

use std::sync::{
    Arc,
    atomic::{AtomicUsize, Ordering},
};

use wholestring::{
    dynamics::{BitLaw, BitSettings, Checkpoint, HoistControl, Precision, RockLaw, SetupError},
    prelude::*,
    rock::{BitShape, DrillingSpec, Executor, Rock, bit_face::PdcBit},
    well::Interpolation,
};

use crate::{
    common::{mud, operation, path, rpm, verify},
    wells::{Case, each, go, line, model, statistic, tool},
};

const DEPTH_M: f64 = 100.0;

/// Elements, m.
const SIZE_M: f64 = 6e-3;

/// A bit of 60 mm on a rock of 10 MPa.
fn law() -> RockLaw {
    let rock = Rock::for_drilling(10e6);
    let bit = BitShape::Pdc(PdcBit::for_diameter(0.06));
    let mut drilling = DrillingSpec::new(rock, bit, SIZE_M).expect("a sound face");
    drilling.block.layers_per_slab = 3;
    RockLaw { drilling }
}

/// Collars and pipe in a vertical hole without friction and mud, the block going down steadily: the
/// bit's loads appear at the top.
fn case() -> Case {
    let mut vertical = model(
        path(&[[0.0, 0.0, 0.0], [DEPTH_M + 20.0, 0.0, 0.0]], Interpolation::Spline),
        vec![HoleSection::open(0.0..(DEPTH_M + 20.0), 0.06, 0.0)],
        vec![
            tool("bit", ComponentLength::Metres(0.3), 0.06, 0.0),
            tool("collars", ComponentLength::Metres(60.0), 0.05, 0.01),
            tool("pipe", ComponentLength::ToSurface, 0.05, 0.038),
        ],
        DEPTH_M,
    );
    vertical.mud = mud(0.0);
    let bit = BitSettings { law: BitLaw::Rock(Box::new(law())), ..BitSettings::default() };
    let drill = operation(OperationKind::Drill, DEPTH_M)
        .rotary_speed_rad_per_s(rpm(240.0))
        .weight_on_bit_N(1500.0);
    let drill = bit.drilling_steadily(drill);
    let rate_m_per_s = drill.rate_of_penetration_m_per_s;
    let mut case = Case::new(vertical, drill);
    case.settings.bit = bit;
    case.settings.hoist_control = Some(HoistControl::BlockVelocity(rate_m_per_s));
    case.lasts(0.5, 1.5);
    case
}

/// Weight and torque of the rock are the deficit and the supply of the top of the string, the bit
/// advances at its reported rate, and that of the block, and the energy of the string is accounted
/// for.
#[test]
fn what_the_rock_takes_the_top_gives() {
    let case = case();
    let mut simulation = case.start();
    let weight_N: f64 = simulation
        .mesh()
        .elements
        .iter()
        .map(|e| e.length_m * e.section.buoyed_weight_N_per_m(0.0))
        .sum();
    let [mass_kg, polar_kg_m2] = [weight_N / 9.806_65, {
        let elements = simulation.mesh().elements.iter();
        elements.map(|e| e.length_m * e.section.polar_inertia_kg_m).sum()
    }];
    go(&mut simulation, 2.0);
    let outcome = simulation.outcome();
    let series = &outcome.series;
    let from = series.time_s.partition_point(|t| *t < 0.5 - 1e-9);
    let rows = series.time_s.len() - from;
    let [hook, weight, torque, surface, spin] = [
        "hook_load_N",
        "weight_on_bit_N",
        "bit_torque_N_m",
        "surface_torque_N_m",
        "bit_rotary_speed_rad_per_s",
    ]
    .map(|name| statistic(&outcome, name));
    for (quantity, expected, computed) in [
        (
            "weight on solid rock at the rate that was estimated, N",
            case.operation.weight_on_bit_N,
            weight.mean,
        ),
        (
            "torque on solid rock at the rate that was estimated, N·m",
            case.operation.bit_torque_N_m,
            torque.mean,
        ),
    ] {
        assert!(computed > 0.1 * expected, "the bit drills: {computed}");
        verify("rock", quantity).any("an estimate").report(expected, computed);
    }
    // Hook loads of ±F come with waves of F/ρcA; the lightest pipe has 44 N·s/mm.
    let waves_m_per_s = (hook.max - hook.min) / 35e3;
    let window_s = rows as f64 * simulation.sample_interval_s();
    verify("rock", "mean hook load and weight on solid rock, N")
        .absolute(mass_kg * waves_m_per_s / window_s, "momentum that the string holds in its waves")
        .report(weight_N, hook.mean + weight.mean);
    verify("rock", "mean torque at surface, of solid rock, N·m")
        .absolute(
            polar_kg_m2 * (spin.max - spin.min) / window_s,
            "angular momentum that the string holds in its waves",
        )
        .report(torque.mean, surface.mean);
    let gone_m = series.bit_depth_m[series.bit_depth_m.len() - 1] - series.bit_depth_m[from - 1];
    let rate: f64 = series.rate_of_penetration_m_per_s[from..].iter().sum();
    verify("rock", "way of the bit through solid rock over that by its rate")
        .relative(1e-9, "rounding of depths of 100 m")
        .report(1.0, gone_m / (rate * simulation.sample_interval_s()));
    let (rate, _) = line(&series.time_s[from..], &series.bit_depth_m[from..]);
    verify("rock", "rate of penetration in solid rock under a block that goes down steadily, m/s")
        .relative(
            0.05,
            "the string stretches by a tenth of a millimetre under the variation of the weight",
        )
        .report(case.operation.rate_of_penetration_m_per_s, rate);
    let energy = outcome.numerics.energy.expect("a balance");
    verify(
        "rock",
        "energy of a string on solid rock that is unaccounted for as a part of the bit's work",
    )
    .absolute(
        0.05,
        "first order in the string's step: elements of 3.2, 1.6, 0.8 m have 3.5, 1.3, 1.0 %",
    )
    .report(0.0, energy.residual_J / energy.bit_work_J);
    // The start neither drops the string nor throws it: the hook load departs no further than
    // later.
    let begins = series.time_s.partition_point(|t| *t < 0.3);
    let departure = |hook_N: &[f64]| {
        let off = hook_N.iter().map(|n| (n / hook.mean - 1.0).abs());
        off.fold(0.0, f64::max)
    };
    let first = departure(&series.hook_load_N[..begins]);
    let later = departure(&series.hook_load_N[from..]);
    assert!(first < 1.25 * later, "{first} {later}");
    let bottom = simulation.bottom_hole().expect("rock");
    let known = (0..bottom.rings()).flat_map(|r| (0..bottom.sectors()).map(move |s| (r, s)));
    let depths: Vec<f64> = known.filter_map(|(r, s)| bottom.z_m(r, s)).collect();
    let deepest_m = depths.iter().copied().fold(f64::MIN, f64::max);
    assert_eq!(depths.len(), bottom.rings() * bottom.sectors());
    assert!(deepest_m.abs() < 2.0 * SIZE_M, "{deepest_m}");
}

/// A run with threads of its own has the answer of one without.
#[cfg(feature = "rayon")]
#[test]
fn a_run_with_threads_of_its_own_ends_with_the_same_bits() {
    let mut case = case();
    case.settings.settle_s = 0.0;
    case.settings.duration_s = 0.05;
    let (model, operation, settings) = (&case.model, &case.operation, &case.settings);
    let three = std::num::NonZeroUsize::new(3).expect("three");
    let mut threaded =
        Simulation::with_threads(model, operation, settings, three).expect("threads");
    let mut alone = case.start();
    go(&mut threaded, 0.05);
    go(&mut alone, 0.05);
    assert_eq!(threaded.outcome(), alone.outcome());
}

/// Two threads.
struct Pair;

impl Executor for Pair {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        std::thread::scope(|scope| {
            scope.spawn(|| (0..count / 2).for_each(work));
            (count / 2..count).for_each(work);
        });
    }
}

/// When the runs stop: before the window and within it.
const STOPS_S: [f64; 3] = [0.06, 0.12, 0.2];

/// Written to bytes, dropped, read back, and worked on by two threads from then on; in double and
/// in single precision.
#[test]
fn a_run_on_rock_ends_with_the_same_bits_whoever_works_on_it() {
    let cases = [Precision::Double, Precision::Single].map(|precision| {
        let mut case = case();
        case.settings.precision = precision;
        case.lasts(0.1, 0.1);
        case
    });
    let run = |case: &Case, stopped: &dyn Fn(Simulation) -> Simulation| {
        let mut simulation = case.start();
        for stop_s in STOPS_S {
            let left_s = stop_s - simulation.time_s();
            go(&mut simulation, left_s);
            simulation = stopped(simulation);
        }
        (simulation.outcome(), simulation.bottom_hole())
    };
    let outcomes = each(&cases, |case| {
        let resumed = run(case, &|simulation| {
            let bytes = postcard::to_allocvec(&simulation.checkpoint()).unwrap();
            let checkpoint: Checkpoint = postcard::from_bytes(&bytes).unwrap();
            let (model, operation) = (&case.model, &case.operation);
            let mut resumed =
                Simulation::resume(model, operation, &case.settings, checkpoint).unwrap();
            resumed.set_executor(Arc::new(Pair));
            resumed
        });
        [run(case, &|simulation| simulation), resumed]
    });
    for [straight, resumed] in &outcomes {
        // Their numbers fill pages.
        assert!(straight == resumed);
    }
    // The precision of the string is not that of the rock: they begin alike.
    let [double, single] = [&outcomes[0][0].0.series, &outcomes[1][0].0.series];
    let impulse = |weight_N: &[f64]| weight_N[..3].iter().sum::<f64>();
    let [double, single] = [double, single].map(|series| impulse(&series.weight_on_bit_N));
    verify(
        "rock",
        "weight on solid rock over the first 30 ms in single over that in double precision",
    )
    .relative(0.02, "which element goes first is soon decided in the last digits")
    .report(1.0, single / double);
}

/// Stopped after each of its steps, and written to bytes in the middle of a sample, it ends with the
/// same bits: a sample takes tenths of a second on the rock of a whole bit.
#[test]
fn a_run_on_rock_stops_between_two_steps() {
    let mut case = case();
    case.settings.sample_interval_s = 5e-3;
    case.lasts(0.01, 0.02);
    let mut straight = case.start();
    go(&mut straight, 0.03);
    let mut stopped = case.start();
    let stop = || Arc::new(Impatient { answers: AtomicUsize::new(5), works: AtomicUsize::new(0) });
    stopped.set_executor(stop());
    let (mut calls, mut between) = (0, 0);
    while stopped.samples() < straight.samples() {
        let before_s = stopped.time_s();
        go(&mut stopped, 1.0);
        let steps = (stopped.time_s() - before_s) / stopped.time_step_s();
        assert!((steps - 1.0).abs() < 1e-6, "{steps} steps");
        calls += 1;
        let into_s = stopped.time_s() - stopped.samples() as f64 * stopped.sample_interval_s();
        if into_s > 0.5 * stopped.time_step_s() {
            between += 1;
        }
        if calls == 7 {
            let bytes = postcard::to_allocvec(&stopped.checkpoint()).unwrap();
            let checkpoint: Checkpoint = postcard::from_bytes(&bytes).unwrap();
            let (model, operation) = (&case.model, &case.operation);
            stopped = Simulation::resume(model, operation, &case.settings, checkpoint).unwrap();
            stopped.set_executor(stop());
        }
    }
    assert!(between > calls / 2, "{between} of {calls}");
    assert!(straight.outcome() == stopped.outcome());
}

#[test]
fn a_bit_that_is_lighter_than_what_it_touches_is_refused() {
    let mut case = case();
    let mut law = law();
    law.drilling.block.numerics.density_factor = 4e5;
    case.settings.bit.law = BitLaw::Rock(Box::new(law));
    let error = Simulation::new(&case.model, &case.operation, &case.settings).unwrap_err();
    assert!(matches!(error, SetupError::LightBit { .. }), "{error}");
}

/// Has had enough after so many questions.
struct Impatient {
    answers: AtomicUsize,
    works: AtomicUsize,
}

impl Executor for Impatient {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        self.works.fetch_add(1, Ordering::Relaxed);
        (0..count).for_each(work);
    }

    fn stopped(&self) -> bool {
        self.answers.fetch_add(1, Ordering::Relaxed) >= 5
    }
}

/// A run-in takes minutes on small elements: it is requested between any two of its steps whether
/// to continue.
#[test]
fn a_run_in_stops_within_a_step() {
    let case = case();
    let impatient =
        Arc::new(Impatient { answers: AtomicUsize::new(0), works: AtomicUsize::new(0) });
    let settings = &case.settings;
    let initial =
        Simulation::with_executor(&case.model, &case.operation, settings, impatient.clone());
    assert!(matches!(initial, Err(SetupError::Stopped)));
    assert_eq!(impatient.answers.load(Ordering::Relaxed), 6);
    // Five steps of 0.2 ms, each of some dozens of the rock's own; the whole run-in has hundreds.
    let works = impatient.works.load(Ordering::Relaxed);
    assert!((5..5000).contains(&works), "{works}");
}
