//! Calibration of a known well against an independent solution, and the coverage of its regions.

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
    found.estimates.iter().map(|estimate| estimate.value).collect()
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
            let others: Vec<usize> = (0..3).filter(|&index| index != place).collect();
            let whole = |pair: &[f64]| {
                let mut p = best.clone();
                p[place] = end;
                p[others[0]] = pair[0];
                p[others[1]] = pair[1];
                p
            };
            let held = |pair: &[f64]| chi2(&whole(pair));
            let from: Vec<f64> = others.iter().map(|&index| best[index]).collect();
            let scale: Vec<f64> = others.iter().map(|&index| scale[index]).collect();
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
    for estimate in &found.estimates[..2] {
        assert!((0.15..0.35).contains(&estimate.value), "{estimate:?}");
    }
    assert!(found.confused.is_empty() && found.points.iter().all(|point| !point.outlier));
    assert!(found.interpolation_error < 0.02);
}

/// Estimated errors agree with those in the data.
#[test]
fn s4_errors_of_readings_are_estimated() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let settings = Settings { errors: [None; 3], ..settings() };
    let model = SoftPredictions::new(&assemblies);
    let found = calibrate(&model, &readings(&Oracle::data()), &[], &[], &settings).expect("a fit");
    for (error, made) in found.errors.iter().zip([12e3, 6e3, 500.0]) {
        assert!(!error.given);
        // The standard error of a root mean square of n numbers is 1/√(2 n) of it: within three.
        let most = 3.0 / (2.0 * error.readings as f64).sqrt();
        verify("S4", format!("estimated error of the {} over that made", error.kind.name()))
            .absolute(most, "three standard errors of a root mean square of so many")
            .report(1.0, error.value / made);
    }
}

/// A well that differs from that of the readings is fitted too, but its residuals show it.
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

/// Readings in casing alone, or in open hole alone, do not determine the other.
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
    // Pick-up weights at two neighbouring depths do not separate three parameters.
    let few: Vec<Reading> = readings(&rows[20..])
        .into_iter()
        .filter(|reading| reading.channel == Channel::PickUp)
        .collect();
    let found = calibrate(&model, &few, &[], &[], &settings()).expect("a fit");
    assert!(!found.confused.is_empty() && found.condition > 100.0, "{}", found.condition);
    // At two depths, each read twice, they have two numbers for three, and bands all the same.
    let twice = [few[0], few[0], few[1], few[1]];
    let depths = [(0, few[0].bit_depth_m)];
    let found = calibrate(&model, &twice, &[], &depths, &settings()).expect("a fit with bands");
    assert!(!found.confused.is_empty() && !found.bands.is_empty());
    let one = calibrate(&model, &few[..2], &[], &[], &settings()).expect_err("too few");
    assert_eq!(one, CalibrationError::TooFew { readings: 2, parameters: 3 });
}

/// A model without solutions beyond a friction of 1 in casing.
struct Limited<'a>(SoftPredictions<'a>);

impl Predict for Limited<'_> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.0.reaches(setup, bit_depth_m, part)
    }

    fn loads(&self, requests: &[Asked]) -> Result<Vec<Loads>, CalibrationError> {
        let one = |request: &Asked| match request.factors.cased > 1.0 {
            true => Err(request.no_answer("soft", "no solution".to_owned())),
            false => self.0.one(request),
        };
        requests.iter().map(one).collect()
    }
}

/// A fit that leaves the factors with solutions names the factor and the numbers that the readings
/// do not determine.
#[test]
fn a_factor_that_runs_off_is_named() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = Limited(SoftPredictions::new(&assemblies));
    let rows = readings(&oracle.rows(&Oracle::depths(), [1.2, 0.3, 180e3]));
    let pick_ups: Vec<Reading> =
        rows.into_iter().filter(|reading| reading.channel == Channel::PickUp).collect();
    let error = calibrate(&model, &pick_ups, &[], &[], &settings()).expect_err("runs off");
    let CalibrationError::Undetermined { runaway: Parameter::Cased, value, .. } = &error else {
        panic!("{error}");
    };
    assert!(*value > 0.8, "{value}");
    let text = error.to_string();
    assert!(
        text.starts_with(
            "the readings do not determine the friction factor of casing, the friction factor of \
             open hole and the block weight at once: the fit runs off to a friction factor of \
             casing of"
        ),
        "{text}"
    );
}

/// A factor that would be negative is zero, and is reported at its bound.
#[test]
fn no_factor_is_negative() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let mut readings = readings(&oracle.rows(&Oracle::depths(), [0.0, 0.3, 180e3]));
    // Negative torque in casing.
    for reading in &mut readings {
        if reading.channel == Channel::OffBottomTorque {
            reading.value -= 1e3;
        }
    }
    let found = calibrate(&model, &readings, &[], &[], &settings()).expect("a fit");
    let cased = &found.estimates[0];
    assert!(cased.at_bound && cased.value == 0.0 && cased.standard_error.is_none());
    assert_eq!(cased.interval[0], Some(0.0));
    assert!(cased.interval[1].expect("an end") > 0.0 && !found.estimates[1].at_bound);
}

/// Friction around the hole that differs from that along it is found separately.
#[test]
fn friction_around_the_hole_is_found_apart() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let mut readings = readings(&oracle.rows(&Oracle::depths(), [0.2, 0.3, 180e3]));
    for reading in &mut readings {
        if reading.channel == Channel::OffBottomTorque {
            reading.value *= 0.5;
        }
    }
    let mut parameters = PARAMETERS.to_vec();
    parameters.extend([Parameter::CasedAround, Parameter::OpenAround]);
    let found = calibrate(
        &model,
        &readings,
        &[],
        &[],
        &Settings { parameters, around_apart: true, ..settings() },
    );
    for (value, expected) in values(&found.expect("a fit")).iter().zip([0.2, 0.3, 180e3, 0.1, 0.15])
    {
        assert!((value / expected - 1.0).abs() < 2e-3, "{value} for {expected}");
    }
}

/// A model that caches repeated requests.
struct Remembering<'a> {
    model: SoftPredictions<'a>,
    known: RefCell<HashMap<[u64; 6], Loads>>,
}

impl Predict for Remembering<'_> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.model.reaches(setup, bit_depth_m, part)
    }

    fn loads(&self, requests: &[Asked]) -> Result<Vec<Loads>, CalibrationError> {
        let one = |request: &Asked| {
            let Factors { cased, open, cased_around, open_around, .. } = request.factors;
            let numbers = [request.bit_depth_m, cased, open, cased_around, open_around];
            let mut key = [request.motion as u64; 6];
            for (key, number) in key.iter_mut().zip(numbers) {
                *key = number.to_bits();
            }
            if let Some(loads) = self.known.borrow().get(&key) {
                return Ok(*loads);
            }
            let loads = self.model.one(request)?;
            self.known.borrow_mut().insert(key, loads);
            Ok(loads)
        };
        requests.iter().map(one).collect()
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

/// The number of 200 sets of readings with known noise for which the region of 95 % contains the
/// truth.
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
        let mut sound = sound.clone();
        let mut chi2_at_truth = 0.0;
        for reading in &mut sound {
            let z = noise.normal();
            let error = settings.errors[reading.channel.error().place()].expect("given");
            reading.value += error * z;
            chi2_at_truth += z * z;
        }
        let found = calibrate(&model, &sound, &[], &[], &settings).expect("a fit");
        sets += 1;
        held += usize::from(chi2_at_truth - found.chi2 <= REGION);
        for (held, (estimate, truth)) in
            held_alone.iter_mut().zip(found.estimates.iter().zip(truth))
        {
            let [from, to] = estimate.interval.map(|end| end.expect("an end"));
            *held += usize::from((from..to).contains(&truth));
        }
    }
    let part = |held: usize| 100.0 * held as f64 / f64::from(sets);
    verify("S4", "sets of readings whose region of 95 % contains the truth, %")
        .absolute(4.0, "90 to 98 % are required of 200 sets; their standard error is 1.5 %")
        .report(94.0, part(held));
    for (parameter, held) in PARAMETERS.iter().zip(held_alone) {
        verify(
            "S4",
            format!(
                "sets whose interval of 95 % of the {} contains the truth, %",
                parameter.words()
            ),
        )
        .absolute(4.0, "as of the region")
        .report(94.0, part(held));
    }
}

/// A reading that is held out does not change the results, and is predicted like a band at its
/// depth.
#[test]
fn what_is_held_out_is_predicted() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let all = readings(&Oracle::data());
    let deepest_m = all.iter().map(|reading| reading.bit_depth_m).fold(0.0, f64::max);
    let (held, used): (Vec<_>, Vec<_>) =
        all.iter().partition(|reading| reading.bit_depth_m == deepest_m);
    let depths = [(0, deepest_m)];
    let found = calibrate(&model, &used, &held, &depths, &settings()).expect("a fit");
    let alone = calibrate(&model, &used, &[], &depths, &settings()).expect("a fit");
    assert_eq!(found.estimates, alone.estimates);
    assert_eq!(found.held_out.len(), held.len());
    assert_eq!(found.points.len(), used.len());
    for point in &found.held_out {
        let is = |band: &&BandPoint| band.channel == point.reading.channel;
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
    // Errors ten times as large, so that the bands are wide and nonlinearity shows.
    let errors = settings().errors.map(|error| error.map(|error| 5.0 * error));
    let settings = Settings { errors, ..settings() };
    let rows = Oracle::data();
    let depth_m = 4300.0;
    let found =
        calibrate(&model, &readings(&rows), &[], &[(0, depth_m)], &settings).expect("a fit");
    let best = values(&found);
    let likelihood = |p: &[f64]| -0.5 * oracle.chi2(&rows, p) / 25.0;
    let peak = likelihood(&best);
    // Metropolis with the covariance found; the draws are from the likelihood, not from a Gaussian.
    let lower = cholesky(&found.covariance);
    let mut noise = Noise(11);
    let (mut at, mut height) = (best.clone(), peak);
    let mut samples_drawn: Vec<[f64; 4]> = Vec::new();
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
            samples_drawn.push(oracle.predict(depth_m, [at[0], at[1], at[2]]));
        }
    }
    for (place, channel) in CHANNELS.into_iter().enumerate() {
        let band = found.bands.iter().find(|band| band.channel == channel).expect("a band");
        let mut samples: Vec<f64> = samples_drawn.iter().map(|loads| loads[place]).collect();
        samples.sort_by(f64::total_cmp);
        let quantile = |part: f64| samples[(part * (samples.len() - 1) as f64).round() as usize];
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

fn cholesky(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut lower = vec![vec![0.0; matrix.len()]; matrix.len()];
    for row in 0..matrix.len() {
        for column in 0..=row {
            let sum: f64 = (0..column).map(|k| lower[row][k] * lower[column][k]).sum();
            lower[row][column] = match row == column {
                true => (matrix[row][row] - sum).sqrt(),
                false => (matrix[row][column] - sum) / lower[column][column],
            };
        }
    }
    lower
}

/// Huber's loss finds the wrong readings and no others, whether errors are given or not; the fit
/// without them is that of the unchanged ones.
#[test]
fn outliers_are_those_that_were_made() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let sound = readings(&Oracle::data());
    let settings = Settings { errors: [None; 3], profiles: false, ..settings() };
    // A tight hole, two digits in the wrong order, a torque by half.
    let wrong = [(12, 120e3), (33, -150e3), (70, 150e3), (59, -8e3)];
    let mut changed = sound.clone();
    for (place, off) in wrong {
        changed[place].value += off;
    }
    let found = outliers(&model, &changed, &settings).expect("a fit");
    let places: Vec<usize> = (0..changed.len()).filter(|&place| found.outlier[place]).collect();
    let mut expected: Vec<usize> = wrong.iter().map(|(place, _)| *place).collect();
    expected.sort_unstable();
    assert_eq!((places, found.too_many), (expected, None), "{:?}", found.scales);
    let none = outliers(&model, &sound, &settings).expect("a fit");
    assert!(none.outlier.iter().filter(|is| **is).count() <= 1, "{:?}", none.scales);
    // Where a third of the readings are off, up and down, they are not outliers.
    for (row, readings) in changed.chunks_mut(4).enumerate().filter(|(row, _)| row % 3 == 0) {
        let factor = if row % 2 == 0 { 1.5 } else { 0.5 };
        readings.iter_mut().for_each(|reading| reading.value *= factor);
    }
    let many = outliers(&model, &changed, &settings).expect("a fit");
    assert!(many.too_many.is_some() && !many.outlier.contains(&true), "{many:?}");
}

/// Neither the weight of a block nor the torque of a bit is negative; zeros in place of readings
/// are refused by name.
#[test]
fn no_block_is_negative() {
    let oracle = Oracle::read();
    let assemblies = [assembly(&oracle)];
    let model = SoftPredictions::new(&assemblies);
    let mut readings = readings(&oracle.rows(&Oracle::depths(), [0.2, 0.3, 0.0]));
    for reading in readings.iter_mut().filter(|reading| !reading.channel.is_torque()) {
        reading.value -= 30e3;
    }
    let found = calibrate(&model, &readings, &[], &[], &settings()).expect("a fit");
    let block = &found.estimates[2];
    assert!(block.at_bound && block.value == 0.0, "{block:?}");
    assert_eq!((block.interval[0], block.standard_error), (Some(0.0), None));
    for reading in readings.iter_mut().filter(|reading| reading.channel.is_torque()) {
        reading.value = 0.0;
    }
    let zero = calibrate(&model, &readings, &[], &[], &settings()).expect_err("zeros");
    assert_eq!(zero, CalibrationError::AllZero(ErrorKind::Torque));
    assert!(zero.to_string().contains("the torques are all zero"), "{zero}");
}

/// Predictions in a box that is narrower than the intervals are made anew in a wider one: the ends
/// are found, and they are those of a wide box.
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
