//! The wells and strings of these tests, and how they are run.

use wholestring::{
    dynamics::Statistic,
    outcome::TimeSeries,
    prelude::*,
    statics::soft,
    string::{Cavity, Eccentricity},
    well::Interpolation,
};

use crate::common::{
    self,
    np13::{components, drill_pipe, heavy_weight},
    operation, path,
};
pub use crate::common::{mud_with_drag as mud, np13::tool};

/// A model, its operation, and the settings of its computation.
#[derive(Clone)]
pub struct Case {
    pub model: Model,
    pub operation: Operation,
    pub settings: DynamicsSettings,
}

impl Case {
    /// A case with default settings, 10 s to settle and a window of 10 s.
    pub fn new(model: Model, operation: Operation) -> Self {
        let settings =
            DynamicsSettings { settle_s: 10.0, duration_s: 10.0, ..DynamicsSettings::default() };
        Self { model, operation, settings }
    }

    /// Gives it another time to settle and another window.
    pub fn lasts(&mut self, settle_s: f64, duration_s: f64) {
        self.settings.settle_s = settle_s;
        self.settings.duration_s = duration_s;
    }

    pub fn start(&self) -> Simulation {
        Simulation::new(&self.model, &self.operation, &self.settings).expect("a valid case")
    }

    pub fn run(&self) -> DynamicOutcome {
        let mut simulation = self.start();
        go(&mut simulation, self.settings.settle_s + self.settings.duration_s);
        simulation.outcome()
    }

    pub fn soft(&self) -> SoftProfile {
        soft::solve(&self.model, &self.operation, &soft::SoftSettings::default())
            .expect("a valid case")
    }
}

/// Continues for `seconds`.
#[track_caller]
pub fn go(simulation: &mut Simulation, seconds: f64) {
    if let Err(error) = simulation.advance(seconds) {
        panic!("{error}");
    }
}

/// Does `work` on every item, each in a thread of its own; answers in the order of the items.
pub fn each<I: Sync, T: Send>(items: &[I], work: impl Fn(&I) -> T + Sync) -> Vec<T> {
    std::thread::scope(|scope| {
        let work = &work;
        let threads: Vec<_> = items.iter().map(|item| scope.spawn(move || work(item))).collect();
        threads
            .into_iter()
            .map(|thread| match thread.join() {
                Ok(answer) => answer,
                Err(panic) => std::panic::resume_unwind(panic),
            })
            .collect()
    })
}

/// Mean of the values whose time is in `from_s..to_s`.
pub fn mean_between(time_s: &[f64], values: &[f64], from_s: f64, to_s: f64) -> f64 {
    let chosen: Vec<f64> = between(time_s, values, from_s, to_s);
    chosen.iter().sum::<f64>() / chosen.len() as f64
}

/// The values whose time is in `from_s..to_s`.
pub fn between(time_s: &[f64], values: &[f64], from_s: f64, to_s: f64) -> Vec<f64> {
    time_s
        .iter()
        .zip(values)
        .filter(|(t, _)| **t >= from_s && **t < to_s)
        .map(|(_, v)| *v)
        .collect()
}

/// Slope and intercept of the line of least squares through points.
pub fn line(x: &[f64], y: &[f64]) -> (f64, f64) {
    let n = x.len() as f64;
    let (mx, my) = (x.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let sxy: f64 = x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum();
    let sxx: f64 = x.iter().map(|x| (x - mx) * (x - mx)).sum();
    (sxy / sxx, my - sxy / sxx * mx)
}

/// Statistics of a quantity over the window.
pub fn statistic(outcome: &DynamicOutcome, name: &str) -> Statistic {
    *outcome.statistic(name).expect(name)
}

/// Rate at which the bit moves down from a time on, m/s.
pub fn rate_from(series: &TimeSeries, from_s: f64) -> f64 {
    let from = series.time_s.partition_point(|t| *t < from_s);
    line(&series.time_s[from..], &series.bit_depth_m[from..]).0
}

/// A model of a path, sections of hole and components from the bit up, in the mud of [`mud`].
pub fn model(
    path: Path,
    hole: Vec<HoleSection>,
    components: Vec<ComponentSpec>,
    bit_depth_m: f64,
) -> Model {
    let hole = Hole::new(hole).expect("a sound hole");
    common::model(path, hole, components, mud(), bit_depth_m)
}

/// Changes every section of a model's hole.
pub fn change_hole(model: &mut Model, change: impl Fn(&HoleSection) -> HoleSection) {
    let sections = model.well.hole.sections().iter().map(change);
    model.well.hole = Hole::new(sections.collect()).expect("a sound hole");
}

/// Inclination of the straight holes, deg.
pub const STRAIGHT_DEG: f64 = 60.0;

/// Plain 5-1/2 in pipe in a straight hole of 215.9 mm.
pub fn straight(length_m: f64, mu: f64) -> Model {
    let stations = [[0.0, STRAIGHT_DEG, 20.0], [length_m, STRAIGHT_DEG, 20.0]];
    model(
        path(&stations, Interpolation::Spline),
        vec![HoleSection::open(0.0..length_m, 0.2159, mu)],
        vec![tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186)],
        length_m,
    )
}

/// Depth of the bit in the NP13-like well, m.
pub const NP13_M: f64 = 4305.0;

/// Its kick-off and the end of its build, m.
pub const NP13_BUILD_M: [f64; 2] = [322.9, 1075.0];

/// The well and string of `cases/np13-x1042.toml`, drilled at 70 rev/min with 60 kN on the bit.
pub fn np13(mu: f64) -> Case {
    np13_at(mu, NP13_M)
}

/// The same with the bit at another depth.
pub fn np13_at(mu: f64, bit_depth_m: f64) -> Case {
    let hole = vec![
        HoleSection::casing(0.0..2986.53, 0.22296, mu),
        HoleSection::open(2986.53..(NP13_M + 20.0), 0.2159, mu),
    ];
    let path = path(&np13_survey(), Interpolation::Spline);
    let drill = operation(OperationKind::Drill, bit_depth_m)
        .weight_on_bit_N(58_839.9)
        .bit_torque_N_m(3100.0)
        .rate_of_penetration_m_per_s(10.0 / 3600.0);
    Case::new(model(path, hole, components(), bit_depth_m), drill)
}

/// The same with a string that is eccentric all along, by a millimetre.
pub fn np13_eccentric(mu: f64) -> Case {
    let mut case = np13(mu);
    let mut components = components();
    for component in &mut components {
        let cavity = Cavity::Mud;
        component.eccentricity = Some(Eccentricity { offset_m: 1e-3, phase_rad: 0.0, cavity });
    }
    let string = StringSpec { components }.assemble(case.operation.bit_depth_m);
    case.model.string = string.expect("a sound string");
    case
}

/// The survey that the case file reads: MD in m, inclination and azimuth in degrees under a header.
fn np13_survey() -> Vec<[f64; 3]> {
    let file =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/np13-x1042-survey.csv");
    let text = std::fs::read_to_string(&file)
        .unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    text.lines()
        .skip(1)
        .map(|line| {
            let mut numbers = line.split(',').map(|x| x.trim().parse().expect("a number"));
            std::array::from_fn(|_| numbers.next().expect("three columns"))
        })
        .collect()
}

/// Depth of the bit in the moderately deviated well, m.
pub const MODERATE_M: f64 = 1500.0;

/// A well with a build to 45° by 800 m and a turn of 25° below, in which a string with heavy-weight
/// pipe and collars does `kind` with `mu` everywhere.
pub fn moderate(kind: OperationKind, mu: f64) -> Case {
    use ComponentLength::Metres;
    let mut stations = vec![[0.0, 0.0, 30.0]];
    for i in 0..=20 {
        let part = f64::from(i) / 20.0;
        stations.push([200.0 + 600.0 * part, 45.0 * part, 30.0]);
    }
    for i in 1..=20 {
        let part = f64::from(i) / 20.0;
        stations.push([800.0 + 700.0 * part, 45.0, 30.0 + 25.0 * part]);
    }
    let components = vec![
        tool("bit", Metres(0.3), 0.2159, 0.060),
        tool("drill collar", Metres(55.0), 0.165, 0.0714),
        heavy_weight(93.9),
        drill_pipe(),
    ];
    let hole = vec![
        HoleSection::casing(0.0..700.0, 0.22296, mu),
        HoleSection::open(700.0..(MODERATE_M + 20.0), 0.2159, mu),
    ];
    let operation = operation(kind, MODERATE_M)
        .weight_on_bit_N(40e3)
        .bit_torque_N_m(2000.0)
        .rate_of_penetration_m_per_s(20.0 / 3600.0);
    let path = path(&stations, Interpolation::Spline);
    Case::new(model(path, hole, components, MODERATE_M), operation)
}
