//! What the stiff string costs by its length, and how often and how fast it finds its equilibrium in
//! random wells: `cargo bench -p wholestring --bench stiff_string -- 1000`.
//!
//! Wells of 300 m to 12 km with doglegs to 20 deg/30 m, spline and arcs; motors with and without a
//! bend at three tool faces, none to three blades, friction from 0 to 0.6, every operation. The
//! seeds are fixed: every machine tries the same wells.

#[path = "../tests/common/mod.rs"]
mod common;

use std::time::Instant;

use wholestring::{
    operation::OperationKind,
    prelude::*,
    sizing::{Accuracy, ElementLength},
    statics::{
        soft::{self, SoftSettings},
        stiff::{self, StiffError, StiffSettings},
    },
    string::{Blades, BodyBend, ComponentLength, ComponentSpec, ToolJoints},
    well::Interpolation,
};

use common::{model, mud, open_hole, operation, path, steel};

/// Diameter of the hole, m.
const HOLE_M: f64 = 0.2159;

/// Weights on the bit of what drills and slides, N: none, and about the sinusoidal and the helical
/// load of 5 in pipe that lies in such a hole, and twice that.
const WEIGHTS_N: [f64; 4] = [0.0, 150e3, 220e3, 440e3];

/// Wells of a list.
const LISTED: usize = 12;

/// Wells, where the command does not say.
const WELLS: u64 = 200;

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn one_of<T: Copy, const N: usize>(&mut self, all: [T; N]) -> T {
        all[((self.unit() * N as f64) as usize).min(N - 1)]
    }
}

/// Lengths of the string, km.
const LENGTHS_KM: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 15.0];

/// Times that each is solved; the fastest counts.
const TIMES: usize = 5;

fn main() {
    lengths();
    let wells = std::env::args().find_map(|word| word.parse().ok()).unwrap_or(WELLS);
    let weights =
        WEIGHTS_N.into_iter().flat_map(|weight_N| (0..wells).map(move |seed| (seed, weight_N)));
    let tried: Vec<Try> = weights.map(|(seed, weight_N)| try_well(seed, weight_N)).collect();
    println!(
        "{} of {wells} wells, each with four weights on the bit of what drills or slides;",
        tried.len()
    );
    println!("compression along the soft string:");
    println!("                           wells  found  stable  lock up  rolls  no reason");
    for class in Class::ALL {
        let count = |what: &dyn Fn(&Try) -> bool| {
            tried.iter().filter(|one| Class::of(one) == class && what(one)).count()
        };
        println!(
            "{:25}  {:6} {:6} {:7} {:8} {:6} {:10}",
            class.name(),
            count(&|_| true),
            count(&|one| matches!(one.end, End::Found { .. })),
            count(&|one| one.end == End::Found { stable: true }),
            count(&|one| one.end == End::LocksUp),
            count(&|one| one.end == End::Rolls),
            count(&|one| one.end == End::NotConverged),
        );
    }
    for (name, belongs) in [("found", true), ("not found", false)] {
        let found = tried.iter().filter(|one| matches!(one.end, End::Found { .. }) == belongs);
        let mut times_ms: Vec<f64> = found.map(|one| one.ms).collect();
        times_ms.sort_by(f64::total_cmp);
        if let Some(most) = times_ms.last() {
            let part = |part: f64| times_ms[((times_ms.len() - 1) as f64 * part) as usize];
            println!(
                "{name}: median {:.1} ms, 90 % {:.1} ms, 99 % {:.1} ms, most {most:.1} ms",
                part(0.5),
                part(0.9),
                part(0.99)
            );
        }
    }
    let mut slowest: Vec<&Try> = tried.iter().collect();
    slowest.sort_by(|a, b| b.ms.total_cmp(&a.ms));
    let unexplained = tried.iter().filter(|one| one.end == End::NotConverged);
    let unstable = tried.iter().filter(|one| one.end == End::Found { stable: false });
    list("slowest", slowest.into_iter().take(LISTED));
    list("no reason", unexplained.take(LISTED));
    list("found, but not stable", unstable.take(LISTED));
}

/// Wells of a list, to be looked at.
fn list<'a>(title: &str, of: impl Iterator<Item = &'a Try>) {
    println!("{title}:");
    for one in of {
        let Try { seed, weight_N, kind, ms, steps, over: [sinusoidal, helical], .. } = one;
        println!(
            "  seed {seed}, {:.0} kN, {}: {ms:.0} ms, {steps} steps, {sinusoidal:.2} of the \
             sinusoidal load, {helical:.2} of the helical",
            weight_N / 1e3,
            kind.name()
        );
    }
}

/// A build to 60 deg over a fifth of the length and a tangent, drill pipe with joints from end to end,
/// elements from joint to joint: pulled out, and turning off bottom.
fn lengths() {
    println!("length, km | elements | pulled: iterations, ms | turning: iterations, ms");
    for length_km in LENGTHS_KM {
        let length_m = 1e3 * length_km;
        let stations = [[0.0, 0.0, 0.0], [0.2 * length_m, 60.0, 0.0], [length_m, 60.0, 0.0]];
        let path = path(&stations, Interpolation::MinimumCurvature);
        let pipe = ComponentSpec::uniform(
            "drill pipe",
            0.127,
            0.1086,
            ComponentLength::ToSurface,
            steel(),
        );
        let joints = Some(ToolJoints { od_m: 0.165, spacing_m: 9.6 });
        let parts = vec![ComponentSpec { joints, ..pipe }];
        let model = model(path, open_hole(HOLE_M, 0.25, length_m), parts, mud(1200.0), length_m);
        let settings = StiffSettings {
            element_length: ElementLength::Auto(Accuracy::Coarse),
            ..StiffSettings::default()
        };
        let kinds = [OperationKind::TripOut, OperationKind::RotateOffBottom];
        let [pulled, turning] = kinds.map(|kind| {
            let operation = operation(kind, length_m);
            let solve = |_| {
                let begin = Instant::now();
                let found = stiff::solve(&model, &operation, &settings).expect("an equilibrium");
                (found.convergence, 1e3 * begin.elapsed().as_secs_f64())
            };
            let tries = (0..TIMES).map(solve);
            tries.min_by(|a, b| a.1.total_cmp(&b.1)).expect("one")
        });
        println!(
            "{length_km} | {} | {}, {:.1} | {}, {:.1}",
            pulled.0.elements, pulled.0.iterations, pulled.1, turning.0.iterations, turning.1
        );
    }
}

/// What became of a well.
struct Try {
    seed: u64,
    weight_N: f64,
    kind: OperationKind,
    ms: f64,
    /// Newton steps; none where a string that locks up does not say.
    steps: usize,
    /// The largest compression over the loads of the sinusoid and of the helix.
    over: [f64; 2],
    end: End,
}

/// By the largest compression along the string.
#[derive(Clone, Copy, PartialEq)]
enum Class {
    Below,
    Buckled,
    Beyond,
}

impl Class {
    const ALL: [Self; 3] = [Self::Below, Self::Buckled, Self::Beyond];

    fn of(one: &Try) -> Self {
        match one.over {
            [sinusoidal, _] if sinusoidal < 1.0 => Self::Below,
            [_, helical] if helical <= 2.0 => Self::Buckled,
            _ => Self::Beyond,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Below => "below the sinusoidal load",
            Self::Buckled => "to twice the helical load",
            Self::Beyond => "beyond",
        }
    }
}

#[derive(PartialEq)]
enum End {
    Found { stable: bool },
    LocksUp,
    Rolls,
    NotConverged,
}

fn try_well(seed: u64, weight_N: f64) -> Try {
    let (model, operation) = well(seed, weight_N);
    let begin = Instant::now();
    let solved = stiff::solve(&model, &operation, &StiffSettings::default());
    let ms = 1e3 * begin.elapsed().as_secs_f64();
    let (end, steps) = match solved {
        Ok(found) => {
            let of = found.convergence;
            (End::Found { stable: of.stable }, of.iterations)
        }
        Err(StiffError::LocksUp { .. }) => (End::LocksUp, 0),
        Err(StiffError::RunsAway { iterations, .. }) => (End::LocksUp, iterations),
        Err(StiffError::Rolls { iterations, .. }) => (End::Rolls, iterations),
        Err(StiffError::NotConverged { iterations, .. }) => (End::NotConverged, iterations),
        Err(error) => panic!("well {seed}: {error}"),
    };
    let soft = soft::solve(&model, &operation, &SoftSettings::default()).expect("a soft string");
    let over = [&soft.sinusoidal_load_N, &soft.helical_load_N].map(|loads_N| {
        let pairs = soft.tension_N.iter().zip(loads_N);
        pairs.filter_map(|(tension_N, load_N)| Some(-tension_N / (*load_N)?)).fold(0.0, f64::max)
    });
    Try { seed, weight_N, kind: operation.kind, ms, steps, over, end }
}

/// A random well, its string, and what is done with it.
fn well(seed: u64, weight_N: f64) -> (Model, Operation) {
    let mut random = Random(1000 + seed);
    let depth_m = 300.0 * 40.0_f64.powf(random.unit());
    let stations = stations(&mut random, depth_m);
    let between = random.one_of([Interpolation::Spline, Interpolation::MinimumCurvature]);
    let path = path(&stations, between);
    let hole = open_hole(HOLE_M, random.between(0.0, 0.6), depth_m);
    let parts = components(&mut random, depth_m);
    let model = model(path, hole, parts, mud(1200.0), depth_m);
    let operation = operation(random.one_of(OperationKind::ALL), depth_m)
        .weight_on_bit_N(weight_N)
        .bit_torque_N_m(3000.0)
        .rate_of_penetration_m_per_s(0.005);
    (model, Operation { trip_speed_m_per_s: 0.3, ..operation })
}

/// MD, m, inclination and azimuth, deg, every 30 m.
fn stations(random: &mut Random, depth_m: f64) -> Vec<[f64; 3]> {
    let kick_off_m = depth_m * random.between(0.05, 0.4);
    let steepest_deg = random.between(1.0, if depth_m < 3000.0 { 20.0 } else { 8.0 });
    let held_deg = random.between(20.0, 90.0);
    let (mut md_m, mut inclination, mut azimuth) = (0.0, 0.0_f64, random.between(0.0, 360.0));
    let mut stations = vec![[md_m, inclination, azimuth]];
    while md_m < depth_m {
        md_m += 30.0;
        if md_m > kick_off_m {
            inclination = (inclination + random.unit() * steepest_deg).min(held_deg);
            if inclination >= held_deg {
                let wanders = random.between(-0.2, 0.2) * steepest_deg;
                inclination = (inclination + wanders).clamp(0.0, 100.0);
            }
            let sine = inclination.to_radians().sin().max(0.2);
            azimuth += random.between(-0.5, 0.5) * steepest_deg / sine;
        }
        stations.push([md_m, inclination, azimuth.rem_euclid(360.0)]);
    }
    stations
}

/// Bit, motor, blades between collars, heavy-weight pipe and drill pipe.
fn components(random: &mut Random, depth_m: f64) -> Vec<ComponentSpec> {
    use ComponentLength::{Metres, ToSurface};
    let tool = |name: &str, od_m, id_m, length_m| {
        ComponentSpec::uniform(name, od_m, id_m, Metres(length_m), steel())
    };
    let collar = |length_m| tool("collar", 0.165, 0.0714, length_m);
    let jointed = |spacing_m| Some(ToolJoints { od_m: 0.165, spacing_m });
    let mut motor = tool("motor", 0.172, 0.06, 8.0);
    if random.unit() < 0.4 {
        let [angle_deg, toolface_deg] =
            [random.between(0.5, 2.0), random.one_of([0.0, 90.0, 180.0])];
        motor.bend = Some(BodyBend {
            from_lower_end_m: 2.0,
            angle_rad: f64::to_radians(angle_deg),
            toolface_rad: f64::to_radians(toolface_deg),
        });
    }
    let mut parts = vec![tool("bit", HOLE_M, 0.06, 0.3), motor];
    for _ in 0..random.one_of([0, 1, 2, 3]) {
        let od_m = HOLE_M - random.between(0.0005, 0.012);
        let blades = Some(Blades { od_m, length_m: 0.4 });
        parts.push(ComponentSpec { blades, ..collar(1.5) });
        parts.push(collar(random.between(3.0, 10.0)));
    }
    let heavy = tool("heavy-weight pipe", 0.127, 0.0762, (0.1 * depth_m).min(120.0));
    parts.push(ComponentSpec { joints: jointed(9.4), ..heavy });
    let joints = if random.unit() < 0.8 { jointed(9.6) } else { None };
    let pipe = ComponentSpec::uniform("drill pipe", 0.127, 0.1086, ToSurface, steel());
    parts.push(ComponentSpec { joints, ..pipe });
    parts
}
