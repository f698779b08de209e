//! The threshold of stick-slip from the map against the dynamics of the same case.

use std::f64::consts::TAU;

use nalgebra::{Complex, ComplexField, Vector3};
use wholestring::{
    dynamics::{
        BitLaw, BitRockLaw, BitSettings, CustomLaw, SpeedController, SteadyCut, TopDriveSettings,
    },
    prelude::*,
    sizing::ElementLength,
    string::{ComponentLength, ComponentSpec},
};
use wholestring_verification::verify;
use wholestring_vibration::torsional_stability::{
    StabilityRange, StabilitySettings, Threshold, TorsionalStability,
};

use crate::common::{self, rpm};

const DEPTH_M: f64 = 1200.0;
const WEIGHT_N: f64 = 30e3;

/// A bit whose torque falls with its speed.
#[derive(Debug)]
struct WeakeningBit {
    /// Torque at rest over that at speed, less one.
    by: f64,
}

impl BitRockLaw for WeakeningBit {
    fn name(&self) -> &str {
        "weakening bit"
    }

    fn cut(&self, _state: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let depth_of_cut_m = 3e-8 * weight_on_bit_N;
        let weakens = 1.0 + self.by * (-rotary_speed_rad_per_s / 6.0).exp();
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: 0.05 * weight_on_bit_N * weakens,
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }
}

fn components() -> Vec<ComponentSpec> {
    let steel = common::steel();
    vec![
        ComponentSpec::uniform("collar", 0.165, 0.071, ComponentLength::Metres(120.0), steel),
        ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, steel),
    ]
}

/// 120 m of collars under pipe in a vertical hole that does not rub, turned by a drive under a
/// proportional and integral controller.
fn model() -> Model {
    let stations = [[0.0, 0.0, 0.0], [DEPTH_M, 0.0, 0.0]];
    common::along(&stations, 0.0, components(), common::mud(1200.0))
}

fn settings(controller: SpeedController) -> DynamicsSettings {
    DynamicsSettings {
        mesh: wholestring::dynamics::MeshSettings {
            element_length: ElementLength::Uniform(10.0),
            ..Default::default()
        },
        bit: BitSettings {
            law: BitLaw::Custom(CustomLaw::new(WeakeningBit { by: 1.2 }, 1e8)),
            ..BitSettings::default()
        },
        top_drive: TopDriveSettings::Driven {
            inertia_kg_m2: 1000.0,
            controller,
            torque_limit_N_m: None,
        },
        sample_interval_s: 0.02,
        ..DynamicsSettings::default()
    }
}

fn drilling(settings: &DynamicsSettings, speed: f64) -> Operation {
    let operation =
        Operation::drill(DEPTH_M).rotary_speed_rad_per_s(speed).weight_on_bit_N(WEIGHT_N);
    settings.bit.drilling_steadily(operation)
}

/// By how much a small swing of a frequency grows in a second of the dynamics: its part of the
/// bit's speed in two windows, after a blow at the bit.
fn measured(model: &Model, settings: &DynamicsSettings, speed: f64, frequency_Hz: f64) -> f64 {
    let operation = drilling(settings, speed);
    let mut simulation = Simulation::new(model, &operation, settings).expect("a valid case");
    simulation.advance(10.0).expect("no divergence");
    simulation
        .apply_impulse(|node| (Vector3::zeros(), if node.from_bit_m < 1.0 { 0.05 } else { 0.0 }));
    simulation.advance(120.0).expect("no divergence");
    let series = simulation.series();
    let part = |from_s: f64, lasts_s: f64| {
        let rows = series.time_s.iter().zip(&series.bit_rotary_speed_rad_per_s);
        let sum: Complex<f64> = rows
            .filter(|(t, _)| (from_s..from_s + lasts_s).contains(*t))
            .map(|(t, v)| {
                // A window that shuts out neighbours.
                let window = (std::f64::consts::PI * (t - from_s) / lasts_s).sin().powi(2);
                let (sine, cosine) = (-TAU * frequency_Hz * t).sin_cos();
                Complex::new(cosine, sine) * ((v - speed) * window)
            })
            .sum();
        sum.modulus()
    };
    (part(85.0, 45.0) / part(30.0, 45.0)).ln() / 55.0
}

/// Holds the map's threshold to the dynamics: they grow 5 % below it and die away 5 % above it, and
/// the speed at which their growth crosses zero between the two is the threshold within 5 %.
fn hold_to_the_dynamics(name: &str, model: &Model, settings: &DynamicsSettings, most_rpm: f64) {
    let operation = drilling(settings, rpm(80.0));
    let stability = TorsionalStability::new(model, &operation, settings).expect("a case");
    let map = StabilitySettings {
        speeds_rad_per_s: StabilityRange { from: rpm(20.0), to: rpm(most_rpm), values: 12 },
        ..StabilitySettings::around(&operation)
    };
    let line = stability.line(WEIGHT_N, &map).expect("a line");
    let Threshold::From(threshold) = line.threshold else {
        panic!("no threshold: {:?}", line.threshold);
    };
    let near = line.points.iter().filter(|p| p.rotary_speed_rad_per_s > 0.8 * threshold);
    assert!(near.cloned().all(|point| point.stability.complete));
    let band = stability.band(&map);
    let at = stability.at_weight(WEIGHT_N).expect("a weight");
    let [below, above] = [0.95, 1.05].map(|part| {
        let speed = part * threshold;
        let point = at.point(speed, band).expect("a point").stability;
        let root = point.worst.expect("a root");
        let growth = measured(model, settings, speed, root.frequency_Hz);
        verify("torsional stability", format!("growth at {part} of the threshold, {name}, 1/s"))
            .absolute(
                5e-3,
                "a step of the dynamics: the bit's torque is that of the speed a step before, which \
                 takes 3.4e-3 at 14 Hz and 5e-5 at 0.5 Hz",
            )
            .report(growth, root.growth_per_s);
        growth
    });
    assert!(below > 0.0 && above < 0.0, "{name}: {below} {above}");
    // Zero of the growth.
    let dynamics = threshold * (0.95 + 0.1 * below / (below - above));
    verify("torsional stability", format!("threshold of stick-slip, {name}, rad/s"))
        .relative(0.05, "asked for; growth rates differ by less than they change in that")
        .report(dynamics, threshold);
}

/// Under a stiff drive the string's lowest mode is the last to die away, under one that takes waves
/// of that frequency a mode of the collars at 14 Hz.
#[test]
fn the_threshold_is_that_of_the_dynamics() {
    let model = model();
    for (name, proportional_N_m_s, integral_N_m) in
        [("stiff drive", 38e3, 100e3), ("soft drive", 1000.0, 2000.0)]
    {
        let settings = settings(SpeedController::Pi { proportional_N_m_s, integral_N_m });
        hold_to_the_dynamics(name, &model, &settings, 240.0);
    }
}

/// A string that rubs along a hole of 60°: friction that falls with the sliding speed makes it
/// swing, with a bit whose torque does not.
#[test]
fn friction_that_falls_with_speed_makes_the_string_swing() {
    let friction = Friction { at_rest: 0.6, ..Friction::uniform(0.2) };
    let section = HoleSection { friction, ..common::open_section(0.3, 0.0, DEPTH_M) };
    let hole = Hole::new(vec![section]).expect("a sound hole");
    let path = common::arcs(&[[0.0, 60.0, 0.0], [DEPTH_M, 60.0, 0.0]]);
    let model = common::model(path, hole, components(), common::mud(1200.0), DEPTH_M);
    let controller = SpeedController::Pi { proportional_N_m_s: 38e3, integral_N_m: 100e3 };
    let mut settings = settings(controller);
    settings.bit.law = BitLaw::Custom(CustomLaw::new(WeakeningBit { by: 0.0 }, 1e8));
    hold_to_the_dynamics("falling friction", &model, &settings, 240.0);
}

/// SoftTorque tuned to the string has a lower threshold than a stiff drive; it sends back
/// `(a − 1)/(a + 1)` of the string's frequency, and its threshold is that of a map of all speeds.
#[test]
fn a_tuned_drive_lowers_the_threshold() {
    let model = model();
    let stiff = SpeedController::Pi { proportional_N_m_s: 38e3, integral_N_m: 100e3 };
    let settings = settings(stiff);
    let operation = drilling(&settings, rpm(80.0));
    let stability = TorsionalStability::new(&model, &operation, &settings).expect("a case");
    let map = StabilitySettings::around(&operation);
    let map = StabilitySettings {
        speeds_rad_per_s: StabilityRange { from: rpm(20.0), to: rpm(240.0), values: 23 },
        ..map
    };
    let found = stability.of_case(&map).expect("a case");
    let Threshold::From(before) = found.threshold else {
        panic!("{:?}", found.threshold);
    };
    assert!(found.margin().is_some_and(|margin| (margin - rpm(80.0) / before + 1.0).abs() < 1e-12));
    let tuned = found.tuned.expect("a better drive");
    let Threshold::From(after) = tuned.threshold else {
        panic!("{:?}", tuned.threshold);
    };
    assert!(after < 0.99 * before, "{after} {before}");
    let ratio = tuned.impedance_ratio;
    assert!((tuned.reflection - (ratio - 1.0) / (ratio + 1.0)).abs() < 1e-9);
    let controller = SpeedController::SoftTorque { impedance_ratio: ratio, frequency_Hz: None };
    let line = stability.at_weight(WEIGHT_N).expect("a weight").under(controller).line(&map);
    let Threshold::From(whole) = line.expect("a line").threshold else {
        panic!("a threshold");
    };
    assert!((whole / after - 1.0).abs() < 3e-3, "{whole} {after}");
}
