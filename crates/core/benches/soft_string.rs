//! The soft string on the wells of `benchmarks/peers/problem.json`, answers and times as a line of
//! JSON for `scripts/peers.py`: `cargo bench -p wholestring --bench soft_string`.

#[path = "../tests/common/mod.rs"]
mod common;

use std::{fs, hint::black_box, path::Path, time::Instant};

use serde_json::{Map, Value, json};
use wholestring::{
    model::Model,
    operation::OperationKind,
    statics::soft::{SoftProfile, SoftSettings, SoftString},
    string::{ComponentLength, ComponentSpec, Material},
};

use common::{along, arcs, mud, number, operation};

/// Operations that welleng solves at once, too.
const OPERATIONS: [OperationKind; 3] =
    [OperationKind::TripOut, OperationKind::TripIn, OperationKind::RotateOffBottom];
const REPEATS: usize = 201;

fn main() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../benchmarks/peers/problem.json");
    let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{error}: {file:?}"));
    let problem: Value = serde_json::from_str(&text).expect("JSON");
    let wells = [("deviated", "stations"), ("build", "build"), ("drop", "drop")];
    let answers = wells.map(|(name, key)| {
        let stations = &problem[format!("{key}_md_m_inc_deg_azi_deg")];
        let model = model(&problem, stations);
        (name.to_owned(), solved(&model, number(&problem["station_spacing_m"])))
    });
    println!("{}", Value::Object(Map::from_iter(answers)));
}

/// The plain pipe of the problem in air in one of its wells.
fn model(problem: &Value, stations: &Value) -> Model {
    let value = |key: &str| number(&problem[key]);
    let steel = Material {
        density_kg_per_m3: value("density_kg_per_m3"),
        youngs_modulus_Pa: value("youngs_modulus_Pa"),
        shear_modulus_Pa: value("shear_modulus_Pa"),
        ..Material::STEEL
    };
    let pipe = ComponentSpec::uniform(
        "pipe",
        value("outside_diameter_m"),
        value("inside_diameter_m"),
        ComponentLength::ToSurface,
        steel,
    );
    let corners: Vec<[f64; 3]> = serde_json::from_value(stations.clone()).expect("stations");
    let stations = surveyed(&corners, value("station_spacing_m"));
    along(&stations, value("friction"), vec![pipe], mud(0.0))
}

/// Stations at equal distances between the corners, as a survey has them; m and degrees.
fn surveyed(corners: &[[f64; 3]], spacing_m: f64) -> Vec<[f64; 3]> {
    let path = arcs(corners);
    let mut depths: Vec<f64> = corners.iter().map(|corner| corner[0]).collect();
    let count = (path.last_md_m() / spacing_m) as usize;
    depths.extend((0..=count).map(|i| i as f64 * spacing_m));
    depths.sort_by(f64::total_cmp);
    depths.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    depths.iter().map(|&md| [md, path.at(md).inclination_rad().to_degrees(), 0.0]).collect()
}

/// Hook load and torque of each operation, and the least time of all three: in the pieces that
/// everybody gets, and in pieces as long as the survey's.
fn solved(model: &Model, spacing_m: f64) -> Value {
    let usual = SoftSettings::default();
    let coarse = SoftSettings { step_m: spacing_m, ..SoftSettings::default() };
    let [out, into, turning] = solutions(model, &usual).map(|solution| solution.scalars);
    json!({
        "pick_up_N": out.hook_load_N,
        "slack_off_N": into.hook_load_N,
        "rotating_N": turning.hook_load_N,
        "torque_N_m": turning.surface_torque_N_m,
        "coarse_s": least_s(model, &coarse),
        "fine_s": least_s(model, &usual),
    })
}

/// Solves all three, with their common parts computed once.
fn solutions(model: &Model, settings: &SoftSettings) -> [SoftProfile; 3] {
    let bit_depth_m = model.well.path.last_md_m();
    let string = SoftString::new(model, bit_depth_m, settings).expect("a string");
    OPERATIONS.map(|kind| string.solve(&operation(kind, bit_depth_m)).expect("a solution"))
}

/// Returns the smallest time, s, because disturbances only add to it.
fn least_s(model: &Model, settings: &SoftSettings) -> f64 {
    let once = |_| {
        let begin = Instant::now();
        black_box(solutions(black_box(model), settings));
        begin.elapsed().as_secs_f64()
    };
    (0..REPEATS).map(once).fold(f64::INFINITY, f64::min)
}
