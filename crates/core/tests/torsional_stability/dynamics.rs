//! The threshold of stick-slip from the map against the dynamics of the same case.

use std::f64::consts::TAU;

use nalgebra::{Complex, Vector3};
use wholestring::{
    dynamics::{
        BitLaw, BitRockLaw, BitSettings, CustomLaw, SpeedController, SteadyCut, TopDriveSettings,
    },
    prelude::*,
    sizing::ElementLength,
    string::{ComponentLength, ComponentSpec},
    torsional_stability::{StabilityRange, StabilitySettings, Threshold, TorsionalStability},
};
use wholestring_verification::verify;

use crate::common::{self, rpm};

const DEPTH_M: f64 = 1200.0;
const WEIGHT_N: f64 = 30e3;

/// A bit whose torque falls with its speed.
#[derive(Debug)]
struct WeakeningBit;

impl BitRockLaw for WeakeningBit {
    fn name(&self) -> &str {
        "weakening bit"
    }

    fn cut(&self, _state: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let depth_of_cut_m = 3e-8 * weight_on_bit_N;
        let weakens = 1.0 + 1.2 * (-rotary_speed_rad_per_s / 6.0).exp();
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: 0.05 * weight_on_bit_N * weakens,
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }
}

/// 120 m of collars under pipe in a vertical hole that does not rub, turned by a drive under a
/// proportional and integral controller.
fn model() -> Model {
    let steel = common::steel();
    let collar =
        ComponentSpec::uniform("collar", 0.165, 0.071, ComponentLength::Metres(120.0), steel);
    let pipe = ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, steel);
    common::along(
        &[[0.0, 0.0, 0.0], [DEPTH_M, 0.0, 0.0]],
        0.0,
        vec![collar, pipe],
        common::mud(1200.0),
    )
}

fn settings(controller: SpeedController) -> DynamicsSettings {
    DynamicsSettings {
        mesh: wholestring::dynamics::MeshSettings {
            element_length: ElementLength::Uniform(10.0),
            ..Default::default()
        },
        bit: BitSettings {
            law: BitLaw::Custom(CustomLaw::new(WeakeningBit, 1e8)),
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

/// By how much a small swing of a frequency grows in a second of the dynamics: its part of the bit's
/// speed in two windows, after a blow at the bit.
fn measured(model: &Model, settings: &DynamicsSettings, speed: f64, frequency_Hz: f64) -> f64 {
    let operation = drilling(settings, speed);
    let mut simulation = Simulation::new(model, &operation, settings).expect("a sound case");
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
                Complex::from_polar((v - speed) * window, -TAU * frequency_Hz * t)
            })
            .sum();
        sum.norm()
    };
    (part(85.0, 45.0) / part(30.0, 45.0)).ln() / 55.0
}

#[test]
fn the_threshold_is_that_of_the_dynamics() {
    let model = model();
    for (name, controller) in [
        ("stiff", SpeedController::Pi { proportional_N_m_s: 38e3, integral_N_m: 100e3 }),
        ("soft", SpeedController::Pi { proportional_N_m_s: 1000.0, integral_N_m: 2000.0 }),
    ] {
        let settings = settings(controller);
        let operation = drilling(&settings, rpm(80.0));
        let stability = TorsionalStability::new(&model, &operation, &settings).expect("a case");
        let map = StabilitySettings {
            speeds_rad_per_s: StabilityRange { from: rpm(20.0), to: rpm(240.0), values: 12 },
            ..StabilitySettings::around(&operation)
        };
        let start = std::time::Instant::now();
        let line = stability.line(WEIGHT_N, &map).expect("a line");
        println!("{name}: {:?} in {:?}", line.threshold, start.elapsed());
        for p in &line.points {
            println!("  {:.1} rev/min: {:?}", p.rotary_speed_rad_per_s * 60.0 / TAU, p.stability);
        }
        let Threshold::From(threshold) = line.threshold else {
            panic!("no threshold: {:?}", line.threshold);
        };
        let band = stability.band(&map);
        let at = stability.at_weight(WEIGHT_N).expect("a weight");
        let [below, above] = [0.95, 1.05].map(|part| {
            let speed = part * threshold;
            let point = at.point(speed, band).expect("a point").stability;
            let root = point.worst.expect("a root");
            let growth = measured(&model, &settings, speed, root.frequency_Hz);
            println!("  at {part}: {root:?}, dynamics {growth} 1/s");
            growth
        });
        assert!(below > 0.0 && above < 0.0, "{name}: {below} {above}");
        // Where the growth crosses zero, between the two.
        let dynamics = threshold * (0.95 + 0.1 * below / (below - above));
        verify("torsional stability", format!("threshold of stick-slip, {name} drive, rad/s"))
            .relative(0.05, "what is asked; the growth rates differ by less")
            .report(dynamics, threshold);
    }
}
