//! Axial and torsional modes.

use std::f64::consts::TAU;

use wholestring::{
    dynamics::{DynamicsSettings, HoistLine, HoistSetPoint, RodDamping, Schedule, ScheduleStep},
    prelude::*,
    statics::stiff::StiffSettings,
    string::{ComponentLength, ComponentSpec, Material},
};
use wholestring_vibration::modal::{Family, Mode, SmallMotions};

use crate::{
    common::{self, np13, number, report_worst, rpm, verification, verify},
    rigid,
};

/// D09: axial and torsional modes of a string that is held at the top and free at the bit. Two
/// hundred elements err by 1e-4 in the third; a hoist a hundred thousand times as stiff as the
/// string gives nothing.
#[test]
fn d09_hanging_string() {
    const LENGTH_M: f64 = 1000.0;
    let data = verification("D09_linear_frequencies.json");
    let source = &data["fixed_free_1000m"];
    let input = |key: &str| number(&source["inputs"][key]);
    let steel = Material {
        density_kg_per_m3: input("rho"),
        youngs_modulus_Pa: input("E"),
        shear_modulus_Pa: input("G"),
        ..Material::STEEL
    };
    let part = ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, steel);
    let path = common::arcs(&[[0.0, 0.0, 0.0], [LENGTH_M, 0.0, 0.0]]);
    let hole = common::open_hole(0.3, 0.0, LENGTH_M);
    let model = common::model(path, hole, vec![part], common::mud(0.0), LENGTH_M);
    let operation = Operation::rotate_off_bottom(LENGTH_M).rotary_speed_rad_per_s(1.0);
    let hoist_line =
        HoistLine { stiffness_N_per_m: 1e11, ..DynamicsSettings::default().hoist_line };
    let dynamics = DynamicsSettings { hoist_line, ..DynamicsSettings::default() };
    let motions = SmallMotions::new(&model, &operation, &rigid(5.0), &dynamics).expect("rest");
    let mut rows = Vec::new();
    for (family, key) in [(Family::Axial, "axial_Hz"), (Family::Torsional, "torsional_Hz")] {
        let found = motions.family(family, 3).expect("modes");
        let expected = source[key].as_array().expect("frequencies");
        for (index, (mode, expected)) in found.iter().zip(expected).enumerate() {
            let what = format!("{} mode {} of a string at rest, Hz", family.name(), index + 1);
            rows.push(
                verify("D09", what)
                    .relative(1e-3, "the file's; two hundred elements leave 1e-4")
                    .row(number(expected), mode.frequency_Hz),
            );
        }
    }
    report_worst(rows);
}

/// NP13's string in a hole like its own, off bottom, without friction.
fn np13_turning() -> (Model, Operation) {
    const DEPTH_M: f64 = 4305.0;
    let path = common::path(
        &[[0.0, 0.0, 45.0], [300.0, 0.0, 45.0], [900.0, 60.0, 45.0], [DEPTH_M, 60.0, 45.0]],
        wholestring::well::Interpolation::Spline,
    );
    let hole = common::open_hole(0.2159, 0.0, DEPTH_M);
    let model = common::model(path, hole, np13::components(), common::mud(1200.0), DEPTH_M);
    (model, Operation::rotate_off_bottom(DEPTH_M).rotary_speed_rad_per_s(rpm(60.0)))
}

/// The frequency of the highest peak of a signal near one, Hz, under Hann's window.
fn peak_Hz(signal: &[f64], step_s: f64, near_Hz: f64) -> f64 {
    let mean = signal.iter().sum::<f64>() / signal.len() as f64;
    let length = signal.len() as f64;
    let size = |hertz: f64| {
        let (mut re, mut im) = (0.0, 0.0);
        for (index, value) in signal.iter().enumerate() {
            let window = 0.5 - 0.5 * (TAU * index as f64 / length).cos();
            let (sine, cosine) = (TAU * hertz * step_s * index as f64).sin_cos();
            re += window * (value - mean) * cosine;
            im += window * (value - mean) * sine;
        }
        re.hypot(im)
    };
    const STEPS: usize = 400;
    let hertz = |step: usize| near_Hz * (0.95 + 0.1 * step as f64 / STEPS as f64);
    let best = (1..STEPS).max_by(|a, b| size(hertz(*a)).total_cmp(&size(hertz(*b))));
    let best = best.expect("steps");
    // The parabola through the highest and its neighbours.
    let [a, b, c] = [best - 1, best, best + 1].map(|step| size(hertz(step)));
    hertz(best) + 0.5 * (a - c) / (a - 2.0 * b + c) * (hertz(1) - hertz(0))
}

/// NP13's first three torsional and axial modes against the spectra of the dynamics, which are
/// kicked by a little more speed of the top drive and of the block. The peaks of forty seconds are
/// as sharp as 2e-3; the time step and the mass that it adds take 1e-3 of the axial ones.
#[test]
fn np13_rings_as_its_modes_say() {
    const KICK_S: f64 = 20.0;
    const STEP_S: f64 = 0.02;
    let (model, operation) = np13_turning();
    let kick = ScheduleStep {
        at_s: KICK_S,
        rotary_speed_rad_per_s: Some(rpm(61.0)),
        hoist: Some(HoistSetPoint::BlockVelocity(0.01)),
        ..ScheduleStep::default()
    };
    let dynamics = DynamicsSettings {
        damping: RodDamping { mass_per_s: 0.0, stiffness_s: 1e-5 },
        schedule: Schedule { steps: vec![kick] },
        settle_s: KICK_S,
        duration_s: 40.0,
        sample_interval_s: STEP_S,
        ..DynamicsSettings::default()
    };
    let mut outcome = Simulation::new(&model, &operation, &dynamics).expect("a run");
    let outcome = outcome.to_end().expect("an end");
    let series = &outcome.series;
    let from = series.time_s.iter().position(|time| *time > KICK_S + 0.5).expect("a window");
    let step_s = series.time_s[from + 1] - series.time_s[from];
    let motions =
        SmallMotions::new(&model, &operation, &StiffSettings::default(), &dynamics).expect("rest");
    let mut rows = Vec::new();
    for (family, signal) in [
        (Family::Torsional, &series.surface_torque_N_m[from..]),
        (Family::Axial, &series.hook_load_N[from..]),
    ] {
        let modes: Vec<Mode> = motions.family(family, 3).expect("modes");
        for (index, mode) in modes.iter().enumerate() {
            let rings_Hz = peak_Hz(signal, step_s, mode.frequency_Hz);
            let what = format!("{} mode {} of NP13, Hz", family.name(), index + 1);
            rows.push(
                verify("modes", what)
                    .relative(1e-2, "the peaks of forty seconds of the dynamics")
                    .row(rings_Hz, mode.frequency_Hz),
            );
        }
    }
    report_worst(rows);
}
