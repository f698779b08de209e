//! Calibration of a known well against a solution of its own, and how often its regions hold the
//! truth.

mod oracle;
mod well_of_s4;

use std::{cell::RefCell, collections::HashMap};

use oracle::{Oracle, nelder_mead};
use well_of_s4::{CHANNELS, PARAMETERS, assembly, readings, settings};
use wholestring::prelude::*;
use wholestring_plan::calibration::{
    Asked, BandPoint, Calibration, CalibrationError, Channel, ErrorKind, Factors, HolePart, Loads,
    Parameter, Predict, Reading, Settings, SoftPredictions, calibrate, normal_within, outliers,
};
use wholestring_verification::verify;

/// 95 % of a chi-squared number with three degrees of freedom is below this (Abramowitz and Stegun,
/// table 26.8).
const REGION: f64 = 7.814_73;

fn values(found: &Calibration) -> Vec<f64> {
    found.estimates.iter().map(|of| of.value).collect()
}

/// Values, errors, profile intervals and the sum of squares, each against the independent solution.
#[test]
fn s4_friction_of_casing_and_open_hole_and_block_weight() {
    let oracle = Oracle::read();
    let rows = Oracle::data();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let found = calibrate(&model, &readings(&rows), &[], &[], &settings()).expect("a fit");

    let chi2 = |p: &[f64]| oracle.chi2(&rows, p);
    let scale = [0.01, 0.01, 5e3];
    let best = nelder_mead(chi2, &values(&found), &scale);
    let least = chi2(&best);
    let errors = oracle.standard_errors(&rows, &best);
    for (place, estimate) in found.estimates.iter().enumerate() {
        let name = estimate.parameter.words();
        verify("S4", format!("{name}: apart from the most likely one, standard errors"))
            .absolute(0.02, "steps of 5 m of the soft string, polynomials between factors")
            .report(0.0, (estimate.value - best[place]) / errors[place]);
        let error = estimate.standard_error.expect("not at its bound");
        verify("S4", format!("{name}: its standard error over that of differences"))
            .absolute(0.03, "the file's; differences of the independent solution")
            .report(1.0, error / errors[place]);
        // At an end all others at their best make the square greater by that of 1.96.
        let sought = normal_within(0.95).powi(2);
        for end in estimate.interval.map(|end| end.expect("an end")) {
            let others: Vec<usize> = (0..3).filter(|&of| of != place).collect();
            let whole = |of: &[f64]| {
                let mut p = best.clone();
                p[place] = end;
                p[others[0]] = of[0];
                p[others[1]] = of[1];
                p
            };
            let held = |of: &[f64]| chi2(&whole(of));
            let from: Vec<f64> = others.iter().map(|&of| best[of]).collect();
            let scale: Vec<f64> = others.iter().map(|&of| scale[of]).collect();
            let least_there = held(&nelder_mead(held, &from, &scale));
            // The excess grows by 2 · 1.96 for each standard error.
            let off = ((least_there - least) - sought) / (2.0 * sought.sqrt());
            verify(
                "S4",
                format!("{name}: distance of an end of its profile interval, standard errors"),
            )
            .absolute(0.05, "the file's")
            .report(0.0, off);
        }
    }
    verify("S4", "sum of squared residuals over their errors")
        .absolute(0.5, "the file's; steps of 5 m")
        .report(least, found.chi2);
    assert!(found.chi2 < 100.0, "{}", found.chi2);
    for of in &found.estimates[..2] {
        assert!((0.15..0.35).contains(&of.value), "{of:?}");
    }
    assert!(found.confused.is_empty() && found.points.iter().all(|point| !point.outlier));
    assert!(found.interpolation_error < 0.02);
}

/// Errors that are not given come out as those that were made.
#[test]
fn s4_errors_of_readings_are_estimated() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let settings = Settings { errors: [None; 3], ..settings() };
    let model = SoftPredictions::new(&assemblies);
    let found = calibrate(&model, &readings(&Oracle::data()), &[], &[], &settings).expect("a fit");
    for (of, made) in found.errors.iter().zip([12e3, 6e3, 500.0]) {
        assert!(!of.given);
        // The standard error of a root mean square of n numbers is 1/√(2 n) of it: within three.
        let most = 3.0 / (2.0 * of.readings as f64).sqrt();
        verify("S4", format!("estimated error of the {} over that made", of.kind.name()))
            .absolute(most, "three standard errors of a root mean square of so many")
            .report(1.0, of.value / made);
    }
}

/// A well that is not that of the readings is fitted too, but its residuals tell.
#[test]
fn a_wrong_well_shows_in_the_residuals() {
    let oracle = Oracle::read();
    let mut assembly = assembly(&oracle);
    assembly.setup.well.path = Path::minimum_curvature(&[
        Station::from_degrees(0.0, 0.0, 0.0),
        Station::from_degrees(500.0, 0.0, 0.0),
        Station::from_degrees(1150.0, 50.0, 0.0),
        Station::from_degrees(4500.0, 50.0, 0.0),
    ])
    .expect("a path");
    let assemblies = [assembly];
    let model = SoftPredictions::new(&assemblies);
    let found =
        calibrate(&model, &readings(&Oracle::data()), &[], &[], &settings()).expect("a fit");
    assert!(found.chi2 > 200.0, "{}", found.chi2);
}

/// Casing alone, or open hole alone, cannot tell the other.
#[test]
fn what_readings_cannot_tell_is_said() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let rows = Oracle::data();
    let shallow = readings(&rows[..7]);
    let untold = calibrate(&model, &shallow, &[], &[], &settings()).expect_err("not told");
    assert_eq!(untold, CalibrationError::Untold(Parameter::Open));
    let both = Settings { parameters: vec![Parameter::Friction, Parameter::Open], ..settings() };
    let twice = calibrate(&model, &shallow, &[], &[], &both).expect_err("one number");
    assert_eq!(twice, CalibrationError::Twice(Parameter::Friction, Parameter::Open));
    // Pick-up weights at two neighbouring depths cannot tell three numbers apart.
    let few: Vec<Reading> =
        readings(&rows[20..]).into_iter().filter(|of| of.channel == Channel::PickUp).collect();
    let found = calibrate(&model, &few, &[], &[], &settings()).expect("a fit");
    assert!(!found.confused.is_empty() && found.condition > 100.0, "{}", found.condition);
    let one = calibrate(&model, &few[..2], &[], &[], &settings()).expect_err("too few");
    assert_eq!(one, CalibrationError::TooFew { readings: 2, parameters: 3 });
}

/// A factor that would be negative is zero, and is said to be so.
#[test]
fn no_factor_is_negative() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let mut of = readings(&oracle.rows(&Oracle::depths(), [0.0, 0.3, 180e3]));
    // Less torque than nothing in casing.
    for reading in &mut of {
        if reading.channel == Channel::OffBottomTorque {
            reading.value -= 1e3;
        }
    }
    let found = calibrate(&model, &of, &[], &[], &settings()).expect("a fit");
    let cased = &found.estimates[0];
    assert!(cased.at_bound && cased.value == 0.0 && cased.standard_error.is_none());
    assert_eq!(cased.interval[0], Some(0.0));
    assert!(cased.interval[1].expect("an end") > 0.0 && !found.estimates[1].at_bound);
}

/// Friction around the hole that is not that along it.
#[test]
fn friction_around_the_hole_is_found_apart() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let mut of = readings(&oracle.rows(&Oracle::depths(), [0.2, 0.3, 180e3]));
    for reading in &mut of {
        if reading.channel == Channel::OffBottomTorque {
            reading.value *= 0.5;
        }
    }
    let mut parameters = PARAMETERS.to_vec();
    parameters.extend([Parameter::CasedAround, Parameter::OpenAround]);
    let found = calibrate(
        &model,
        &of,
        &[],
        &[],
        &Settings { parameters, around_apart: true, ..settings() },
    );
    for (value, expected) in values(&found.expect("a fit")).iter().zip([0.2, 0.3, 180e3, 0.1, 0.15])
    {
        assert!((value / expected - 1.0).abs() < 2e-3, "{value} for {expected}");
    }
}

/// A model that is asked the same again and again.
struct Remembering<'a> {
    model: SoftPredictions<'a>,
    known: RefCell<HashMap<[u64; 6], Loads>>,
}

impl Predict for Remembering<'_> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.model.reaches(setup, bit_depth_m, part)
    }

    fn loads(&self, asked: &[Asked]) -> Result<Vec<Loads>, CalibrationError> {
        let one = |asked: &Asked| {
            let Factors { cased, open, cased_around, open_around, .. } = asked.factors;
            let numbers = [asked.bit_depth_m, cased, open, cased_around, open_around];
            let mut key = [asked.motion as u64; 6];
            for (key, number) in key.iter_mut().zip(numbers) {
                *key = number.to_bits();
            }
            if let Some(loads) = self.known.borrow().get(&key) {
                return Ok(*loads);
            }
            let loads = self.model.one(asked)?;
            self.known.borrow_mut().insert(key, loads);
            Ok(loads)
        };
        asked.iter().map(one).collect()
    }
}

/// Normal numbers, seeded.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        // Vigna's splitmix64.
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

/// Of 200 sets of readings with known noise, the region of 95 % holds the truth of so many.
#[test]
fn regions_hold_the_truth_as_often_as_they_say() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let known = RefCell::default();
    let model = Remembering { model: SoftPredictions::new(&assemblies), known };
    let truth = [0.2, 0.28, 180e3];
    let depths: Vec<f64> = Oracle::depths().into_iter().step_by(2).collect();
    let sound = readings(&oracle.rows(&depths, truth));
    let (mut held, mut held_alone, mut sets) = (0, [0; 3], 0);
    let mut noise = Noise(4);
    let settings = Settings { profiles: false, ..settings() };
    for _ in 0..200 {
        let mut of = sound.clone();
        let mut chi2_at_truth = 0.0;
        for reading in &mut of {
            let z = noise.normal();
            let error = settings.errors[reading.channel.error().place()].expect("given");
            reading.value += error * z;
            chi2_at_truth += z * z;
        }
        let found = calibrate(&model, &of, &[], &[], &settings).expect("a fit");
        sets += 1;
        held += usize::from(chi2_at_truth - found.chi2 <= REGION);
        for (held, (of, truth)) in held_alone.iter_mut().zip(found.estimates.iter().zip(truth)) {
            let [from, to] = of.interval.map(|end| end.expect("an end"));
            *held += usize::from((from..to).contains(&truth));
        }
    }
    let part = |held: usize| 100.0 * held as f64 / f64::from(sets);
    verify("S4", "sets of readings whose region of 95 % holds the truth, %")
        .absolute(4.0, "90 to 98 % were asked of 200 sets; their standard error is 1.5 %")
        .report(94.0, part(held));
    for (of, held) in PARAMETERS.iter().zip(held_alone) {
        verify(
            "S4",
            format!("sets whose interval of 95 % of the {} holds the truth, %", of.words()),
        )
        .absolute(4.0, "as of the region")
        .report(94.0, part(held));
    }
}

/// A reading that is held out changes nothing that is found, and is predicted as a band at its depth is.
#[test]
fn what_is_held_out_is_predicted() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let all = readings(&Oracle::data());
    let deepest_m = all.iter().map(|of| of.bit_depth_m).fold(0.0, f64::max);
    let (held, used): (Vec<_>, Vec<_>) = all.iter().partition(|of| of.bit_depth_m == deepest_m);
    let depths = [(0, deepest_m)];
    let found = calibrate(&model, &used, &held, &depths, &settings()).expect("a fit");
    let alone = calibrate(&model, &used, &[], &depths, &settings()).expect("a fit");
    assert_eq!(found.estimates, alone.estimates);
    assert_eq!(found.held_out.len(), held.len());
    assert_eq!(found.points.len(), used.len());
    for point in &found.held_out {
        let is = |of: &&BandPoint| of.channel == point.reading.channel;
        let band = alone.bands.iter().find(is).expect("a band");
        assert_eq!(point.predicted, band.predicted);
        // Noise of its known size: no reading of the file is five standard errors off.
        assert!(point.standardised.abs() < 5.0, "{point:?}");
        let residual = point.reading.value - point.predicted;
        assert_eq!(point.within_band, residual.abs() <= band.reading_half_width);
    }
}

/// Bands by slopes are those of samples from the likelihood itself.
#[test]
fn bands_are_those_of_samples() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    // Errors ten times as large, that the bands are wide and what is not linear shows.
    let errors = settings().errors.map(|error| error.map(|error| 5.0 * error));
    let settings = Settings { errors, ..settings() };
    let rows = Oracle::data();
    let depth_m = 4300.0;
    let found =
        calibrate(&model, &readings(&rows), &[], &[(0, depth_m)], &settings).expect("a fit");
    let best = values(&found);
    let likelihood = |p: &[f64]| -0.5 * oracle.chi2(&rows, p) / 25.0;
    let peak = likelihood(&best);
    // Metropolis with the covariance found; what is drawn is of the likelihood, not of a Gaussian.
    let lower = cholesky(&found.covariance);
    let mut noise = Noise(11);
    let (mut at, mut height) = (best.clone(), peak);
    let mut drawn: Vec<[f64; 4]> = Vec::new();
    for step in 0..12_000 {
        let z: Vec<f64> = (0..3).map(|_| noise.normal()).collect();
        let mut to = at.clone();
        for (row, to) in to.iter_mut().enumerate() {
            *to += 1.3 * (0..=row).map(|column| lower[row][column] * z[column]).sum::<f64>();
        }
        let there = likelihood(&to);
        if (there - height).exp() > noise.uniform() {
            (at, height) = (to, there);
        }
        if step >= 500 && step % 4 == 0 {
            drawn.push(oracle.predict(depth_m, [at[0], at[1], at[2]]));
        }
    }
    for (place, channel) in CHANNELS.into_iter().enumerate() {
        let band = found.bands.iter().find(|band| band.channel == channel).expect("a band");
        let mut of: Vec<f64> = drawn.iter().map(|of| of[place]).collect();
        of.sort_by(f64::total_cmp);
        let quantile = |part: f64| of[(part * (of.len() - 1) as f64).round() as usize];
        let half_width = 0.5 * (quantile(0.95) - quantile(0.05));
        let name = channel.name().replace('_', "-");
        verify("S4", format!("{name}: half-width of the band over that of samples"))
            .absolute(
                0.1,
                "samples that hang together: about 500 apart, whose quantiles vary by 5 %",
            )
            .report(1.0, band.mean_half_width / half_width);
        let spread = settings.errors[channel.error().place()].expect("given");
        let reading = (band.mean_half_width / found.band_factor).hypot(spread);
        assert!((band.reading_half_width / (found.band_factor * reading) - 1.0).abs() < 1e-9);
    }
    assert_eq!(ErrorKind::ALL.len(), found.errors.len());
}

fn cholesky(of: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut lower = vec![vec![0.0; of.len()]; of.len()];
    for row in 0..of.len() {
        for column in 0..=row {
            let sum: f64 = (0..column).map(|k| lower[row][k] * lower[column][k]).sum();
            lower[row][column] = match row == column {
                true => (of[row][row] - sum).sqrt(),
                false => (of[row][column] - sum) / lower[column][column],
            };
        }
    }
    lower
}

/// Readings that were written wrongly are found by Huber's loss and no others, whether their errors are given or
/// not; the fit without them is that of the sound ones.
#[test]
fn outliers_are_those_that_were_made() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let sound = readings(&Oracle::data());
    let settings = Settings { errors: [None; 3], profiles: false, ..settings() };
    // A tight hole, two digits in the wrong order, a torque by half.
    let wrong = [(12, 120e3), (33, -150e3), (70, 150e3), (59, -8e3)];
    let mut of = sound.clone();
    for (place, off) in wrong {
        of[place].value += off;
    }
    let found = outliers(&model, &of, &settings).expect("a fit");
    let places: Vec<usize> = (0..of.len()).filter(|&place| found.outlier[place]).collect();
    let mut expected: Vec<usize> = wrong.iter().map(|of| of.0).collect();
    expected.sort_unstable();
    assert_eq!((places, found.too_many), (expected, None), "{:?}", found.scales);
    let none = outliers(&model, &sound, &settings).expect("a fit");
    assert!(none.outlier.iter().filter(|is| **is).count() <= 1, "{:?}", none.scales);
    // Where a third of the readings are off, up and down, it is not a matter of outliers.
    for (row, readings) in of.chunks_mut(4).enumerate().filter(|(row, _)| row % 3 == 0) {
        let factor = if row % 2 == 0 { 1.5 } else { 0.5 };
        readings.iter_mut().for_each(|of| of.value *= factor);
    }
    let many = outliers(&model, &of, &settings).expect("a fit");
    assert!(many.too_many.is_some() && !many.outlier.contains(&true), "{many:?}");
}

/// Neither a block nor a bit weighs or turns less than nothing; zeros in place of readings are refused by name.
#[test]
fn no_block_is_negative() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let mut of = readings(&oracle.rows(&Oracle::depths(), [0.2, 0.3, 0.0]));
    for reading in of.iter_mut().filter(|of| !of.channel.is_torque()) {
        reading.value -= 30e3;
    }
    let found = calibrate(&model, &of, &[], &[], &settings()).expect("a fit");
    let block = &found.estimates[2];
    assert!(block.at_bound && block.value == 0.0, "{block:?}");
    assert_eq!((block.interval[0], block.standard_error), (Some(0.0), None));
    for reading in of.iter_mut().filter(|of| of.channel.is_torque()) {
        reading.value = 0.0;
    }
    let zero = calibrate(&model, &of, &[], &[], &settings()).expect_err("zeros");
    assert_eq!(zero, CalibrationError::AllZero(ErrorKind::Torque));
    assert!(zero.to_string().contains("the torques are all zero"), "{zero}");
}

/// Predictions in a box that is narrower than the intervals are made anew in a wider one: the ends are found, and
/// they are those of a wide box.
#[test]
fn intervals_beyond_a_narrow_box_are_found() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let rows = Oracle::data();
    let few = readings(&rows[15..]);
    let wide = calibrate(&model, &few, &[], &[], &settings()).expect("a fit");
    let values = values(&wide);
    let narrow = Settings {
        first_box: [values[0].min(values[1]) - 0.01, values[0].max(values[1]) + 0.01],
        nodes: 3,
        ..settings()
    };
    let found = calibrate(&model, &few, &[], &[], &narrow).expect("a fit");
    for (one, other) in found.estimates.iter().zip(&wide.estimates).take(2) {
        let error = other.standard_error.expect("an error");
        for (end, expected) in one.interval.iter().zip(other.interval) {
            let apart = (end.expect("an end") - expected.expect("an end")) / error;
            // Predictions between nodes are off by up to a fiftieth of a reading's error.
            assert!(apart.abs() < 0.05, "{one:?}\n{other:?}");
        }
    }
}
