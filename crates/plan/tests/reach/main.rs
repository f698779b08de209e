//! The reach of strings: of a tangent against closed forms and independent integrations, and what
//! stops others.

mod buckling;
mod stops;
mod tangent;

use serde_json::Value;
use wholestring::{
    mud::Rheology,
    prelude::*,
    statics::{
        buckling::Criterion,
        soft::{SoftSettings, solve},
    },
};
use wholestring_judge::{CheckKind, DepthLimit, DesignFactors};
use wholestring_plan::{
    Setup,
    reach::{
        Curve, End, LEAST_MARGIN, ReachError, ReachSettings, first_stop, margins, reach,
        reach_unless,
    },
    root,
};

#[track_caller]
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

/// The uniform pipe of the studies along stations of MD in m and inclination in degrees.
fn setup(inputs: &Value, stations: &[[f64; 2]], friction: f64) -> Setup {
    let pipe = &inputs["pipe"];
    let stations: Vec<Station> =
        stations.iter().map(|[md_m, inc]| Station::from_degrees(*md_m, *inc, 0.0)).collect();
    let path = Path::minimum_curvature(&stations).expect("a path");
    let section = HoleSection::open(0.0..100e3, number(&inputs["hole_m"]), friction);
    let (area_m2, weight_N_per_m) = (number(&pipe["A"]), number(&pipe["w"]));
    let material = Material {
        // In a mud of no density: the same weight.
        density_kg_per_m3: weight_N_per_m / (area_m2 * wholestring::GRAVITY_M_PER_S2),
        youngs_modulus_Pa: number(&pipe["E"]),
        shear_modulus_Pa: number(&pipe["G"]),
        ..Material::STEEL
    };
    let pipe = ComponentSpec::uniform(
        "pipe",
        number(&pipe["od"]),
        number(&pipe["id"]),
        ToSurface,
        material,
    );
    Setup {
        well: Well { path, hole: Hole::new(vec![section]).expect("a hole") },
        string: StringSpec::from_bit(pipe),
        mud: Mud::of_density(0.0),
        fluids: Default::default(),
        rig: Rig {
            block_weight_N: Some(200e3),
            top_drive_torque_N_m: inputs["top_drive_limit_Nm"].as_f64(),
            ..Rig::default()
        },
        ends: Default::default(),
        buckling: Criterion::HeKyllingstad,
    }
}

fn operation(kind: OperationKind, inputs: &Value) -> Operation {
    Operation::new(kind, 0.0)
        .rotary_speed_rad_per_s(10.0)
        .weight_on_bit_N(number(&inputs["WOB_N"]))
        .bit_torque_N_m(number(&inputs["bit_torque_Nm"]))
}

const PLAIN: SoftSettings = SoftSettings { step_m: 5.0, helix_side_force: false };
const HELIX: SoftSettings = SoftSettings { step_m: 5.0, helix_side_force: true };

/// Required factors of one.
const ONE: DesignFactors = DesignFactors {
    tension: 1.0,
    torsion: 1.0,
    tension_and_torsion: 1.0,
    von_mises: 1.0,
    burst: 1.0,
    collapse: 1.0,
    make_up: 1.0,
    side_force: 1.0,
    hoist: 1.0,
    top_drive: 1.0,
    top_drive_peak: 1.0,
    breakaway: 1.0,
    pump_pressure: 1.0,
    sinusoidal_buckling: 1.0,
    helical_buckling: 1.0,
    lock_up: 1.0,
    overpull: 1.0,
};

/// Settings of a soft string, with required factors of one: the limits themselves.
fn of_soft(soft: SoftSettings) -> ReachSettings {
    ReachSettings { soft, factors: ONE, ..ReachSettings::from_depth(1000.0) }
}
