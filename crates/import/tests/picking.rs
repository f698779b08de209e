//! Weights and torques picked from logs with known values.

mod rig_log;

use proptest::prelude::*;
use rig_log::{Manner, Rig, TRUTH};
use wholestring_import::{
    Choices, ImportErrorKind, Note, Record,
    picking::{Estimate, Kind, Picks, Refusal, Thresholds, Window, Work, pick},
};
use wholestring_units::{Dimension, Unit};

fn kN() -> &'static Unit {
    Dimension::Force.find_unit("kN").unwrap()
}

fn said(weight: &str) -> Choices {
    Choices::default().value("block-weight", weight)
}

fn picked_as(rig: &Rig, choices: &Choices) -> Result<Picks, String> {
    let picks = pick(rig.log(), "rig.csv", kN(), &Thresholds::default(), choices);
    picks.map_err(|error| error.to_string())
}

fn picked(rig: &Rig) -> Picks {
    picked_as(rig, &said("245 kN")).unwrap()
}

/// Out of the hole, in again, and some stands drilled.
fn a_day(manner: Manner) -> Rig {
    let mut rig = Rig::new(manner, TRUTH, 3000.0, 3000.0);
    rig.trips_out(6);
    rig.trips_in(6);
    rig.drills_a_stand();
    rig.drills_a_stand();
    rig.drills_a_stand();
    rig
}

fn of(picks: &Picks, kind: Kind) -> impl Iterator<Item = &Window> {
    picks.windows.iter().filter(move |window| window.kind == kind)
}

/// Checks that the picked values are within 4.5 standard errors of the truth for the noise of the
/// log: of the hundreds of values in the tests, one in a hundred thousand exceeds this.
fn assert_true(picks: &Picks, manner: &Manner) {
    let holds = |found: &Estimate, truth: f64, noise: f64, what: &str| {
        let error = 1.2533 * noise / (found.rows as f64).sqrt();
        let off = (found.value - truth).abs();
        assert!(off <= 4.5 * error, "{what}: {found:?} is not {truth}, {off} off, error {error}");
    };
    for window in &picks.windows {
        let depth = window.bit_depth_m;
        let weight = match window.kind {
            Kind::PickUp => Some(TRUTH.pick_up_N),
            Kind::SlackOff => Some(TRUTH.slack_off_N),
            Kind::Rotating => Some(TRUTH.rotating_N),
            Kind::Drilling => None,
        };
        if let (Some(found), Some(truth)) = (&window.weight_N, weight) {
            let truth = truth(depth) + manner.block_N;
            holds(found, truth, manner.weight_noise_N, window.kind.words());
        }
        if let Some(found) = &window.torque_N_m {
            let drills = window.kind == Kind::Drilling;
            let truth = if drills { TRUTH.torque_on_bottom_N_m } else { TRUTH.torque_N_m };
            let truth = truth(depth);
            // A wave is sampled at arbitrary phases: its mean has the error of as many unordered
            // rows.
            let swing = manner.stick_slip * truth * (0.5 * (1.0 + 0.09_f64)).sqrt();
            let noise = manner.torque_noise_N_m.hypot(swing);
            holds(found, truth, noise, "torque");
        }
    }
}

fn assert_out_of_slips(picks: &Picks, rig: &Rig) {
    for window in &picks.windows {
        for (from_s, to_s) in &rig.slips {
            assert!(
                window.to_s < *from_s || window.from_s > *to_s,
                "{window:?} in slips {from_s} to {to_s}"
            );
        }
    }
}

#[test]
fn weights_and_torques_come_out_within_the_noise_at_any_rate() {
    for step_s in [1.0, 2.0, 5.0, 10.0] {
        let manner = Manner { step_s, ..Manner::default() };
        let rig = a_day(manner);
        let picks = picked(&rig);
        assert_true(&picks, &manner);
        assert_out_of_slips(&picks, &rig);
        let counts = Kind::ALL.map(|kind| of(&picks, kind).count());
        // Six stands out and three drilled; six in and three drilled; three drilled. In rows 10 s
        // apart, 7 m down at 0.15 m/s are too short.
        let slack_off = if step_s < 10.0 { 9 } else { 6 };
        assert_eq!(counts, [9, slack_off, 3, 3], "{step_s} s: {:?}", picks.counts);
        let counts = &picks.counts;
        // The last connection out and the first one in are the same.
        assert_eq!((counts.connections, counts.slips_alone), (14, 0), "{step_s} s");
        assert_eq!((counts.stands, counts.drilled), (15, 3), "{step_s} s");
        let trips: Vec<_> = counts.trips.iter().map(|trip| (trip.out, trip.stands)).collect();
        assert_eq!(trips, [(true, 6), (false, 6)], "{step_s} s");
    }
}

#[test]
fn spikes_silences_and_swings_move_nothing() {
    for (seed, step_s) in [(1, 1.0), (2, 1.0), (3, 5.0), (4, 10.0)] {
        let faults = Some(400);
        let manner = Manner { seed, step_s, faults, stick_slip: 0.4, ..Manner::default() };
        let rig = a_day(manner);
        let picks = picked(&rig);
        assert_true(&picks, &manner);
        assert_out_of_slips(&picks, &rig);
        let counts = &picks.counts;
        assert_eq!((counts.connections, counts.drilled), (14, 3), "{step_s} s: {counts:?}");
        // A gap may remove a window, but not many.
        assert!(picks.windows.len() >= 20, "{step_s} s: {} {counts:?}", picks.windows.len());
    }
}

/// The reported standard errors agree with the noise.
#[test]
fn standard_errors_are_those_of_the_noise() {
    let mut off = Vec::new();
    for seed in 1..=12 {
        let picks = picked(&a_day(Manner { seed, ..Manner::default() }));
        for window in of(&picks, Kind::Rotating) {
            let found = window.weight_N.unwrap();
            off.push(
                (found.value - 245e3 - (TRUTH.rotating_N)(window.bit_depth_m))
                    / found.standard_error,
            );
        }
    }
    let rms = (off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64).sqrt();
    // Of 36 normal values the root mean square is within 1 ± 3/√72; choosing the best of several
    // windows of a stand, of which there is one here, does not narrow it.
    assert!((rms - 1.0).abs() < 0.36, "{rms} of {}", off.len());
}

#[test]
fn readings_stand_by_stand_and_depth_by_depth() {
    let rig = a_day(Manner::default());
    let picks = picked(&rig);
    let readings = picks.readings();
    let count = |reading: fn(&wholestring_tabular::ImportedReading) -> Option<f64>| {
        readings.iter().filter_map(reading).count()
    };
    assert_eq!(count(|reading| reading.pick_up_N), 9);
    assert_eq!(count(|reading| reading.slack_off_N), 9);
    assert_eq!(count(|reading| reading.rotating_N), 3);
    assert_eq!(count(|reading| reading.torque_N_m), 3);
    assert_eq!(count(|reading| reading.torque_on_bottom_N_m), 3);
    assert!(readings[0].place.starts_with("stand 1, 0.0"), "{}", readings[0].place);
    // Weights are those of the weight indicator.
    let first = &readings[0];
    let truth = (TRUTH.pick_up_N)(first.bit_depth_m) + 245e3;
    assert!((first.pick_up_N.unwrap() - truth).abs() < 5e3);
    let works: Vec<_> = picks.details.iter().map(|detail| detail.work).collect();
    assert!(works.contains(&Work::TrippedOut) && works.contains(&Work::TrippedIn), "{works:?}");
}

#[test]
fn what_is_told_of_a_log() {
    let fragment = picked(&a_day(Manner::default())).fragment();
    let notes = fragment.notes.iter().map(|note| format!("{}: {}", note.kind(), note.text()));
    let text = format!("{}\n{}", fragment.what, notes.collect::<Vec<_>>().join("\n"));
    insta::assert_snapshot!(text);
    let block = fragment.rig.get("block_weight").unwrap();
    assert_eq!(block.si(), Some(245e3));
}

#[test]
fn the_weight_of_the_block_is_asked_for() {
    let rig = a_day(Manner::default());
    insta::assert_snapshot!(picked_as(&rig, &Choices::default()).unwrap_err());
}

#[test]
fn a_weight_of_the_block_that_cannot_be_is_refused() {
    let rig = a_day(Manner::default());
    let errors =
        ["120 kN", "25 m", "-1 kN", "25"].map(|weight| picked_as(&rig, &said(weight)).unwrap_err());
    insta::assert_snapshot!(errors.join("\n"));
}

/// A sensor zeroed with the block on it gives the same weights.
#[test]
fn a_zeroed_sensor_is_noticed_and_the_block_added() {
    let manner = Manner { zeroed: true, ..Manner::default() };
    let picks = picked(&a_day(manner));
    assert!(!picks.block.in_log);
    assert_eq!(picks.windows.len(), 24);
    assert_true(&picks, &manner);
    let notes = picks.fragment().notes;
    let added = notes.iter().any(
        |note| matches!(note, Note::Assumed(text) if text.contains("were added to the weights")),
    );
    assert!(added, "{notes:?}");
}

#[test]
fn without_a_rotary_speed_the_torque_tells_it() {
    let mut rig = a_day(Manner::default());
    for record in &mut rig.records {
        record.rotary_speed_rad_per_s = f64::NAN;
    }
    let picks = picked(&rig);
    assert_true(&picks, &Manner::default());
    assert_eq!(picks.windows.len(), 24, "{:?}", picks.counts);
    for record in &mut rig.records {
        record.torque_N_m = f64::NAN;
    }
    assert_eq!(picked(&rig).windows, []);
}

#[test]
fn without_a_height_of_the_block_the_bit_tells_it() {
    let mut rig = a_day(Manner::default());
    for record in &mut rig.records {
        record.block_position_m = f64::NAN;
    }
    let picks = picked(&rig);
    assert_true(&picks, &Manner::default());
    assert_out_of_slips(&picks, &rig);
    assert_eq!(picks.windows.len(), 24, "{:?}", picks.counts);
}

/// The zero of the block's height changes in the middle of stands, with and without bit depth.
#[test]
fn a_new_zero_of_the_block_is_no_motion() {
    let mut rig = a_day(Manner::default());
    let count = rig.records.len();
    for (at, record) in rig.records.iter_mut().enumerate() {
        record.block_position_m += 0.7 * (at * 23 / count) as f64 - 5.0;
    }
    let picks = picked(&rig);
    assert_true(&picks, &Manner::default());
    assert_out_of_slips(&picks, &rig);
    assert!(picks.windows.len() >= 20, "{:?}", picks.counts);
}

#[test]
fn a_log_that_tells_too_little_is_refused() {
    let rig = a_day(Manner::default());
    let without = |change: fn(&mut Record)| {
        let mut records = rig.records.clone();
        records.iter_mut().for_each(change);
        let records = records.into_iter().map(Ok);
        let limits = Thresholds::default();
        pick(records, "rig.csv", kN(), &limits, &said("245 kN")).unwrap_err().to_string()
    };
    let errors = [
        without(|record| record.time_s = f64::NAN),
        without(|record| record.time_s *= 30.0),
        without(|record| record.hook_load_N = f64::NAN),
        without(|record| record.bit_depth_m = f64::NAN),
        without(|record| record.hole_depth_m = -999.25),
        without(|record| record.hook_load_N = record.hook_load_N.min(250e3)),
        pick([Ok(rig.records[0])], "rig.csv", kN(), &Thresholds::default(), &said("1 kN"))
            .unwrap_err()
            .to_string(),
        pick([], "rig.csv", kN(), &Thresholds::default(), &said("1 kN")).unwrap_err().to_string(),
    ];
    insta::assert_snapshot!(errors.join("\n"));
}

/// A floater with heave: the weights swing by a seventh of the string's weight.
#[test]
fn what_is_not_steady_is_refused() {
    let manner = Manner { heave: (120e3, 9.7), ..Manner::default() };
    let picks = picked(&a_day(manner));
    let weights = picks.windows.iter().filter(|window| window.weight_N.is_some()).count();
    assert_eq!(weights, 0, "{:?}", picks.windows);
    let unsteady = |((_, why), _): (&(Kind, Refusal), &usize)| *why == Refusal::Unsteady;
    assert!(picks.counts.refused.iter().any(unsteady), "{:?}", picks.counts.refused);
}

/// A string that sticks at times: its torque off bottom is not the friction of a turning string.
#[test]
fn a_string_that_stands_still_at_times_gives_no_torque() {
    let manner = Manner { stick_slip: 1.3, ..Manner::default() };
    let picks = picked(&a_day(manner));
    assert_eq!(of(&picks, Kind::Rotating).filter(|window| window.torque_N_m.is_some()).count(), 0);
    assert_eq!(of(&picks, Kind::Drilling).count(), 0);
    assert!(picks.counts.refused.contains_key(&(Kind::Drilling, Refusal::Swinging)));
}

#[test]
fn an_option_that_is_not_asked_for_is_told() {
    let survey = b"MD (ft),Inc,Azi\n0,0,0\n1000,0,0\n";
    let files = vec![wholestring_import::Input::of_bytes("survey.csv", survey)];
    let error = wholestring_import::import(files, &said("25 tf")).unwrap_err();
    assert!(matches!(error.kind(), ImportErrorKind::Unused { .. }), "{error}");
    assert!(error.to_string().contains("--value block-weight"), "{error}");
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -100.0..5000.0,
        2 => 1e5..2e6,
        1 => any::<f64>(),
        1 => Just(f64::NAN),
        1 => Just(0.0),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// For any noise and rate, no window is in slips and every value is true.
    #[test]
    fn no_window_is_in_slips(seed in 1_u64.., step_s in 0.5..10.0, stick_slip in 0.0..0.6) {
        let manner = Manner { seed, step_s, stick_slip, faults: Some(300), ..Manner::default() };
        let rig = a_day(manner);
        let picks = picked(&rig);
        assert_out_of_slips(&picks, &rig);
        // The slowest log leaves only rotation off bottom and drilling.
        prop_assert!(picks.windows.len() >= 6, "{:?}", picks.counts);
    }

    /// Another scale of the forces gives the same windows and weights of that scale.
    #[test]
    fn the_scale_of_forces_changes_no_window(scale in 0.4..3.0) {
        let mut rig = a_day(Manner::default());
        let picks = picked(&rig);
        for record in &mut rig.records {
            record.hook_load_N *= scale;
        }
        let scaled = picked_as(&rig, &said(&format!("{} kN", 245.0 * scale))).unwrap();
        prop_assert_eq!(picks.windows.len(), scaled.windows.len());
        for (window, other) in picks.windows.iter().zip(&scaled.windows) {
            prop_assert_eq!((window.from_s, window.to_s), (other.from_s, other.to_s));
            if let (Some(own), Some(other)) = (window.weight_N, other.weight_N) {
                let off: f64 = scale * own.value / other.value - 1.0;
                prop_assert!(off.abs() < 1e-12);
            }
        }
    }

    /// Random rows give a result or an error, and no panic.
    #[test]
    fn rows_of_anything_do_no_harm(
        rows in prop::collection::vec(prop::array::uniform8(any_number()), 0..300),
        times in any::<bool>(),
    ) {
        let records = rows.iter().enumerate().map(|(at, row)| Ok(Record {
            time_s: if times { at as f64 } else { row[0] },
            bit_depth_m: row[1],
            hole_depth_m: row[2],
            block_position_m: row[3],
            hook_load_N: row[4],
            torque_N_m: row[5],
            rotary_speed_rad_per_s: row[6],
            weight_on_bit_N: row[7],
            ..Record::NONE
        }));
        let picks = pick(records, "rig.csv", kN(), &Thresholds::default(), &said("10 kN"));
        if let Ok(picks) = picks {
            picks.readings();
        }
    }
}

/// A block weight ten times that in slips is an error of typing, not a zeroed sensor.
#[test]
fn a_block_weight_in_another_unit_is_refused_with_the_ratio() {
    let rig = a_day(Manner::default());
    for (weight, cause) in [
        ("2450 kN", "10 times as much, which indicates a typing error or a weight of kN as tonnes"),
        ("24.5 kN", "0.1 times as much, which indicates a typing error"),
        ("245 klbf", "times as much, which indicates a weight of kN as klbf"),
        ("1500 kN", "times as much"),
    ] {
        let error = picked_as(&rig, &said(weight)).unwrap_err();
        assert!(error.contains("the median hook load in slips is 245 kN"), "{weight}: {error}");
        assert_eq!(error.contains(cause), weight != "1500 kN", "{weight}: {error}");
    }
}

/// Notes of the left-out values of a log with changed records.
fn left_out(change: fn(&mut Record)) -> (Picks, String) {
    let mut rig = a_day(Manner::default());
    rig.records.iter_mut().for_each(change);
    let picks = picked(&rig);
    let notes = picks.notes().into_iter().filter(|note| matches!(note, Note::LeftOut(_)));
    let notes = notes.map(|note| note.text().to_owned()).collect::<Vec<_>>().join("\n");
    (picks, notes)
}

#[test]
fn picks_that_are_left_out_have_a_reason() {
    let (picks, torque) = left_out(|record| record.torque_N_m *= 1e3);
    assert!(picks.windows.iter().all(|window| window.torque_N_m.is_none()));
    let (turned, below) = left_out(|record| {
        record.hole_depth_m = record.bit_depth_m - 50.0;
    });
    assert!(turned.readings().is_empty());
    let (_, feet) = left_out(|record| record.bit_depth_m /= 0.3048);
    let (surface, zero) = left_out(|record| record.bit_depth_m = 0.0);
    assert!(surface.readings().is_empty());
    insta::assert_snapshot!([torque, below, feet, zero].join("\n---\n"));
}

/// A sensor that always gives the same load gives no readings.
#[test]
fn a_hook_load_that_never_changes_is_no_reading() {
    let load: fn(f64) -> f64 = |_| 900e3;
    let truth = rig_log::Truth { pick_up_N: load, slack_off_N: load, rotating_N: load, ..TRUTH };
    let manner = Manner { weight_noise_N: 0.0, ..Manner::default() };
    let mut rig = Rig::new(manner, truth, 3000.0, 3000.0);
    rig.trips_out(6);
    rig.trips_in(6);
    let picks = picked(&rig);
    assert!(picks.windows.len() >= 6);
    let readings = picks.readings();
    assert!(readings.iter().all(|reading| reading.pick_up_N.is_none()));
    assert!(readings.iter().all(|reading| reading.slack_off_N.is_none()));
    let notes = picks.notes();
    let is_said = |note: &Note| note.text().starts_with("THE HOOK LOAD NEVER CHANGES: it is 11");
    assert!(notes.iter().any(is_said), "{notes:#?}");
}

/// The bit hangs on the block: depths of another unit show in their travels.
#[test]
fn depths_in_metres_under_feet_are_warned_of() {
    let is_said = |note: &Note| note.text().starts_with("THE BIT MOVES 0.305 TIMES AS FAR");
    let mut rig = a_day(Manner::default());
    assert!(!picked(&rig).notes().iter().any(is_said));
    for record in &mut rig.records {
        record.bit_depth_m *= 0.3048;
        record.hole_depth_m *= 0.3048;
    }
    let notes = picked(&rig).notes();
    assert!(notes.iter().any(is_said), "{notes:#?}");
}
