//! From the log of a rig over picked weights to friction, and to a page.

#[path = "../../import/tests/rig_log/mod.rs"]
mod rig_log;

use std::path::Path;

use rig_log::{Manner, Rig, STAND_M, TRUTH, Truth};
use wholestring_import::{
    Choices,
    picking::{Picks, Thresholds, Work, pick},
};
use wholestring_plan::calibration::{
    Asked, Assembly, Channel, Factors, Motion, Parameter, Reading, Settings, SoftPredictions,
    State, calibrate,
};
use wholestring_report::{picked_stand_figure, picks_html};
use wholestring_units::{Dimension, UnitSet};

const BLOCK_N: f64 = 245e3;

fn picks<Of: Fn(f64) -> f64>(rig: &Rig<Of>) -> Picks {
    let unit = Dimension::Force.find_unit("kN").unwrap();
    let choices = Choices::default().value("block-weight", "245 kN");
    pick(rig.log(), "rig.csv", unit, &Thresholds::default(), &choices).unwrap()
}

/// A piecewise linear function with values at even steps.
fn lines(from: f64, step: f64, values: Vec<f64>) -> impl Fn(f64) -> f64 {
    move |at| {
        let place = ((at - from) / step).clamp(0.0, (values.len() - 2) as f64);
        let below = place as usize;
        values[below] + (place - below as f64) * (values[below + 1] - values[below])
    }
}

/// A string of a case is tripped and drilled with known friction, its weights are logged with
/// noise, and the friction from the log agrees within its own standard errors.
#[test]
fn friction_comes_back_from_the_log_of_a_rig() {
    let made = Factors::of_walls(0.23, 0.34);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
    let case = wholestring_case::load(&file, &[]).expect("a valid case");
    let assemblies = [Assembly::new(case.setup(), &case.operations)];
    let model = SoftPredictions::new(&assemblies);
    let (from, step) = (300.0, 10.0);
    // Weights and torques of the soft string every 10 m.
    let curve = |motion: Motion, torque: bool| -> Box<dyn Fn(f64) -> f64> {
        let at = |place: usize| {
            let bit_depth_m = from + step * place as f64;
            let loads = model.one(&Asked { setup: 0, bit_depth_m, motion, factors: made });
            let loads = loads.expect("an answer");
            if torque { loads.torque_N_m } else { loads.hook_load_N }
        };
        Box::new(lines(from, step, (0..=90).map(at).collect()))
    };
    let truth = Truth {
        pick_up_N: curve(Motion::PickUp, false),
        slack_off_N: curve(Motion::SlackOff, false),
        rotating_N: curve(Motion::Rotating, false),
        torque_N_m: curve(Motion::Rotating, true),
        torque_on_bottom_N_m: curve(Motion::Drilling, true),
    };
    let (weight_noise_N, torque_noise_N_m) = (4e3, 200.0);
    let manner = Manner {
        weight_noise_N,
        torque_noise_N_m,
        stick_slip: 0.3,
        faults: Some(500),
        ..Manner::default()
    };
    let depth = 1080.0;
    let mut rig = Rig::new(manner, truth, depth, depth);
    rig.trips_out(20);
    rig.trips_in(20);
    for _ in 0..4 {
        rig.drills_a_stand();
    }
    assert!(depth + 4.0 * STAND_M <= 1200.0);
    let picks = picks(&rig);
    let readings: Vec<Reading> = picks
        .readings()
        .iter()
        .flat_map(|reading| {
            let values = [
                (Channel::PickUp, reading.pick_up_N),
                (Channel::SlackOff, reading.slack_off_N),
                (Channel::Rotating, reading.rotating_N),
                (Channel::OffBottomTorque, reading.torque_N_m),
            ];
            let bit_depth_m = reading.bit_depth_m;
            values.into_iter().filter_map(move |(channel, value)| {
                Some(Reading { setup: 0, bit_depth_m, channel, value: value? })
            })
        })
        .collect();
    assert!(readings.len() > 45, "{}", readings.len());
    let factors = Factors::of_walls(0.2, 0.2);
    let held = State { factors, block_weight_N: BLOCK_N, bit_torque_N_m: 0.0 };
    let settings = Settings {
        // Remaining error after averaging the noise over some 40 rows.
        errors: [Some(weight_noise_N / 5.0), Some(weight_noise_N / 5.0), Some(100.0)],
        ..Settings::new(vec![Parameter::Cased, Parameter::Open], held)
    };
    let found = calibrate(&model, &readings, &[], &[], &settings).expect("a fit");
    for (estimate, truth) in found.estimates.iter().zip([made.cased, made.open]) {
        let error = estimate.standard_error.expect("not at its bound");
        let off = (estimate.value - truth) / error;
        println!(
            "{:?}: {:.4} ± {error:.4}, made with {truth}: {off:.2} errors",
            estimate.parameter, estimate.value
        );
        // Both of two normal numbers are within three errors with 99.5 % probability; the seed is
        // fixed.
        assert!(off.abs() < 3.0 && error < 0.03, "{estimate:?}");
    }
}

/// The page contains every picture in every set of units, whatever the name of the file; it is kept
/// in the test's folder for inspection.
#[test]
fn a_page_of_picked_weights() {
    let manner = Manner { faults: Some(700), stick_slip: 0.25, ..Manner::default() };
    let mut rig = Rig::new(manner, TRUTH, 3000.0, 3000.0);
    rig.trips_out(8);
    rig.trips_in(8);
    for _ in 0..4 {
        rig.drills_a_stand();
    }
    let mut picks = picks(&rig);
    picks.file = "logs/<b>rig.csv".to_owned();
    let html = picks_html(&picks, UnitSet::Si);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("picks.html"), &html).unwrap();
    assert!(!html.contains("<b>rig"), "the name is text");
    // A log, a picture against depth and one for each stand drawn, in three sets of units, for a
    // wide page and for a narrow one.
    assert_eq!(html.matches("<svg class=\"figure\"").count(), 2 * 3 * (2 + picks.details.len()));
    assert!(!html.contains("href=\".svg\""), "no link to what is not there");
    // 8000 rows; a page of ten million is as large.
    assert!(html.len() < 6_000_000, "{}", html.len());
}

/// The picture of a drilled stand in the book, kept in the test's folder.
#[test]
fn a_stand_as_the_book_shows_it() {
    let manner = Manner { stick_slip: 0.25, ..Manner::default() };
    let mut rig = Rig::new(manner, TRUTH, 3000.0, 3000.0);
    rig.drills_a_stand();
    rig.drills_a_stand();
    let picks = picks(&rig);
    let drilled = picks.details.iter().find(|stand| stand.work == Work::Drilled);
    let figure = picked_stand_figure(&picks, drilled.expect("one was drilled"), UnitSet::Si);
    let svg = figure.drawing().svg();
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("picks.svg");
    std::fs::write(file, &svg).unwrap();
    for label in ["pick-up", "slack-off", "rotating off bottom", "drilling"] {
        assert!(svg.contains(label), "{label}");
    }
}
