//! Speed of the engine's parts on NP13-X1042, for its developers:
//! `cargo bench -p wholestring`.
//!
//! `wholestring bench` shows the speed of a machine; this reports whether a change made a part
//! slower.

#[path = "../tests/common/mod.rs"]
mod common;
// Written for the tests of the dynamics.
#[allow(dead_code)]
#[path = "../tests/dynamics/wells.rs"]
mod wells;

use std::{hint::black_box, time::Duration};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use wholestring::{
    dynamics::{MeshSettings, NodeSignal, Precision, Probe, Simulation},
    internals::{KernelAccess, instruction_sets},
    operation::Operation,
    rock::{Alone, Block, BlockSpec, Rock, Stepper},
    statics::stiff::{self, StiffSettings},
};

use wells::{Case, NP13_M, go, np13, np13_at, np13_eccentric};

/// Steps of the inner loop that are timed at once: between two followings of the nodes.
const STEPS: usize = 16;

/// The string of a case, initialised and settled, the window begun.
fn settled(mut case: Case, precision: Precision) -> Simulation {
    case.settings.precision = precision;
    case.settings.settle_s = 1.0;
    let mut simulation = case.start();
    go(&mut simulation, 1.1);
    simulation
}

/// The inner loop, per element and step, with each instruction set.
fn kernel(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("kernel");
    for (name, precision) in [("double", Precision::Double), ("single", Precision::Single)] {
        let mut simulation = settled(np13(0.3), precision);
        group.throughput(Throughput::Elements((STEPS * simulation.elements()) as u64));
        for instructions in instruction_sets() {
            simulation.use_instructions(instructions);
            group.bench_function(format!("{name}/{instructions}"), |bencher| {
                bencher.iter(|| simulation.step_kernel(STEPS));
            });
        }
        let mut eccentric = settled(np13_eccentric(0.3), precision);
        group.bench_function(format!("{name}/eccentric all along"), |bencher| {
            bencher.iter(|| eccentric.step_kernel(STEPS));
        });
    }
    group.finish();
}

/// A sample of the records with the steps before it, and a frame of the whole string.
fn records(criterion: &mut Criterion) {
    let settled = settled(np13(0.3), Precision::Double);
    let sample_s = settled.sample_interval_s();
    let mut group = criterion.benchmark_group("records");
    // A fresh copy for each sample would not be in the caches.
    let mut running = settled.clone();
    group.bench_function("sample", |bencher| {
        bencher.iter(|| go(&mut running, sample_s));
    });
    group.bench_function("frame", |bencher| bencher.iter(|| settled.frame()));
    group.bench_function("outcome", |bencher| bencher.iter(|| settled.outcome()));
    group.finish();
}

/// Whole runs and their inner loop, per element and step, by the length of the elements, the
/// precision and the interval between samples: the difference is due to statistics and the ends of
/// the string.
fn runs(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("run");
    let precisions = [("double", Precision::Double), ("single", Precision::Single)];
    for (element_m, (name, precision)) in
        [3.2, 9.6].into_iter().flat_map(|m| precisions.map(|precision| (m, precision)))
    {
        let sampled = |interval_s: f64, probes: &[Probe]| {
            let mut case = np13(0.3);
            case.settings.mesh = MeshSettings::uniform(element_m);
            case.settings.precision = precision;
            case.settings.sample_interval_s = interval_s;
            case.settings.settle_s = 1.0;
            case.settings.probes = probes.to_vec();
            let mut simulation = case.start();
            go(&mut simulation, 1.1);
            simulation
        };
        let probes = [NodeSignal::BendingMoment, NodeSignal::ContactForce, NodeSignal::Tension]
            .map(|signal| Probe { md_m: NP13_M - 20.0, signal });
        let mut kernel = sampled(0.01, &[]);
        let elements = kernel.elements();
        group.throughput(Throughput::Elements((STEPS * elements) as u64));
        group.bench_function(format!("{element_m} m/{name}/inner loop"), |bencher| {
            bencher.iter(|| kernel.step_kernel(STEPS));
        });
        for (what, mut simulation) in [
            ("every 10 ms", sampled(0.01, &[])),
            ("every 1 ms", sampled(0.001, &[])),
            ("every 1 ms with probes", sampled(0.001, &probes)),
        ] {
            // As much as a whole number of samples: 0.1 s or a little more or less.
            let samples = (0.1 / simulation.sample_interval_s()).round();
            let seconds = samples * simulation.sample_interval_s();
            let steps = (seconds / simulation.time_step_s()).round() as usize;
            group.throughput(Throughput::Elements((steps * elements) as u64));
            group.bench_function(format!("{element_m} m/{name}/{what}"), |bencher| {
                bencher.iter(|| go(&mut simulation, seconds));
            });
        }
    }
    group.finish();
}

/// The soft string, the stiff one on two meshes, and the start of the dynamics.
fn statics(criterion: &mut Criterion) {
    let case = np13(0.3);
    criterion.bench_function("soft string", |bencher| {
        bencher.iter(|| black_box(&case).soft());
    });
    let mut group = criterion.benchmark_group("stiff string");
    for (name, mesh) in [("auto", MeshSettings::default()), ("3.2 m", MeshSettings::uniform(3.2))] {
        let settings =
            StiffSettings { element_length: mesh.element_length, ..StiffSettings::default() };
        group.bench_function(name, |bencher| {
            bencher.iter(|| stiff::solve(black_box(&case.model), &case.operation, &settings));
        });
        let heavier =
            Operation { weight_on_bit_N: 1.1 * case.operation.weight_on_bit_N, ..case.operation };
        let near = stiff::equilibrium(&case.model, &heavier, &settings).expect("an equilibrium");
        group.bench_function(format!("{name}, from a tenth more weight"), |bencher| {
            let model = black_box(&case.model);
            bencher.iter(|| stiff::equilibrium_near(model, &case.operation, &settings, &near));
        });
    }
    group.sample_size(10);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    group.bench_function(format!("broomstick of 450 on {threads} threads"), |bencher| {
        bencher.iter(|| broomstick(threads));
    });
    group.finish();
    let mut group = criterion.benchmark_group("start");
    group.sample_size(10);
    group.bench_function("lay", |bencher| {
        bencher.iter(|| Case::start(black_box(&case)));
    });
    group.finish();
}

/// Pick-up, slack-off and rotating off bottom at three friction factors and fifty depths, each from
/// the middle of the hole.
fn broomstick(threads: usize) {
    let solve = |index: usize| {
        let depth_m = 300.0 + (NP13_M - 300.0) * (index / 9) as f64 / 49.0;
        let case = np13_at([0.2, 0.3, 0.4][index % 3], depth_m);
        let operation = match index / 3 % 3 {
            0 => Operation::trip_out(depth_m),
            1 => Operation::trip_in(depth_m),
            _ => Operation::rotate_off_bottom(depth_m),
        };
        // A string that cannot go down has no equilibrium: its solution takes time, too.
        black_box(stiff::solve(&case.model, &operation, &StiffSettings::default())).ok();
    };
    std::thread::scope(|scope| {
        for first in 0..threads {
            scope.spawn(move || (first..450).step_by(threads).for_each(solve));
        }
    });
}

/// A step of a block of rock, per element, with each instruction set: one that stays in the
/// second-level cache, and a live zone of a bit. The return to the cone is computed whether an
/// element yields or not.
fn rock(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("rock");
    for (name, cells) in [("small", [32, 16, 16]), ("live zone", [96, 96, 12])] {
        let squeezed = squeezed(cells);
        group.throughput(Throughput::Elements(squeezed.grid().elements() as u64));
        for stepper in Stepper::all() {
            let mut block = squeezed.clone();
            group.bench_function(format!("{name}/{}", stepper.instructions), |bencher| {
                bencher.iter(|| block.step(&stepper, &Alone));
            });
        }
    }
    group.finish();
}

/// A block of rock that does not soften, moving and beyond yield.
fn squeezed(cells: [usize; 3]) -> Block {
    let rock = Rock {
        tensile_fracture_energy_J_per_m2: 1e30,
        compressive_fracture_energy_J_per_m2: 1e30,
        ..Rock::of_strength(30e6)
    };
    let mut block = Block::new(&BlockSpec::new(rock, cells, 1e-3)).expect("a sound block");
    let grid = *block.grid();
    for node in grid.each_node() {
        let [x, y, z] = node.map(|n| n as f64);
        block.tell(grid.node(node), [2.0 * y.sin(), 2.0 * z.cos(), -x - z]);
    }
    for _ in 0..20 {
        block.step(&Stepper::default(), &Alone);
    }
    block
}

criterion_group! {
    name = benches;
    config = Criterion::default().measurement_time(Duration::from_secs(3));
    targets = kernel, records, runs, statics, rock
}
criterion_main!(benches);
