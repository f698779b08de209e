//! From readings to friction factors.

use super::{
    BandPoint, Calibration, CalibrationError, Channel, Confused, ErrorKind, Estimate, Motion,
    Parameter, Point, Predict, Reading, ReadingError, Settings,
    best::{Best, best},
    fit::Likelihood,
    profile::Along,
    quantile::{normal_within, student_within},
    spread::Spread,
    surface::{Station, stations},
};

/// Step of the finite differences for the bands, as a part of a standard error, and its least and
/// largest value: the error of a factor that the readings do not determine has no bound, and a string
/// with such friction no solution.
const SLOPE_PART: f64 = 0.3;
const LEAST_SLOPE: f64 = 1e-3;
const LARGEST_SLOPE: f64 = 0.5;

/// Finds the parameters that make readings most likely, and their uncertainty; and predicts the
/// readings with the bit of each setup at other depths, m. Readings that are held out are not used
/// in the fit; they are compared with the predictions from the others.
///
/// # Errors
/// Readings that do not determine the parameters, or a string for which the model has no solution.
pub fn calibrate(
    model: &impl Predict,
    readings: &[Reading],
    held_out: &[Reading],
    depths: &[(usize, f64)],
    settings: &Settings,
) -> Result<Calibration, CalibrationError> {
    check(readings, settings)?;
    check_finite(held_out)?;
    let (stations, station_of) = stations(model, settings, readings);
    let freedom = readings.len() - settings.parameters.len();
    let kinds = readings.iter().map(|reading| reading.channel.error());
    let estimated = kinds.clone().any(|kind| settings.errors[kind.place()].is_none());
    let within = |probability: f64| match estimated && freedom > 0 {
        true => student_within(probability, freedom as f64),
        false => normal_within(probability),
    };
    let interval_factor = within(settings.confidence);
    let best = best(model, settings, readings, (&stations, &station_of), interval_factor)?;
    let likelihood = Likelihood {
        settings,
        surfaces: &best.surfaces,
        readings,
        station_of: &station_of,
        errors: best.errors,
        weights: Vec::new(),
    };
    let design = likelihood.design(&best.values);
    let spread = Spread::of(&design, &best.at_bound, settings)?;
    // The uncertainty of a factor at its bound, for the extent of its profile.
    let all = Spread::of(&design, &vec![false; best.values.len()], settings)?;
    let band_factor = within(settings.band_confidence);
    let points = points(&likelihood, &best, &spread, band_factor);
    let (bands, more) = bands(model, settings, readings, depths, &best, &spread, band_factor)?;
    let (held_out, yet_more) =
        held_out_points(model, settings, held_out, &best, &spread, band_factor)?;
    let chi2 = likelihood.chi2(&best.values);
    Ok(Calibration {
        estimates: estimates(&likelihood, &best, &spread, &all, interval_factor)?,
        state: settings.state(&best.values),
        correlation: square(best.values.len(), |a, b| spread.correlation(a, b)),
        covariance: square(best.values.len(), |a, b| spread.covariance[(a, b)]),
        condition: spread.condition,
        confused: confused(settings, &spread),
        errors: errors(&likelihood, &best),
        chi2,
        degrees_of_freedom: freedom,
        log_likelihood: log_likelihood(&likelihood, chi2),
        interval_factor,
        band_factor,
        points,
        held_out,
        bands,
        interpolation_error: best.interpolation_error,
        strings: best.strings + more + yet_more,
    })
}

pub(super) fn check(readings: &[Reading], settings: &Settings) -> Result<(), CalibrationError> {
    let parameters = &settings.parameters;
    if parameters.is_empty() {
        return Err(CalibrationError::NothingAsked);
    }
    for (place, &first) in parameters.iter().enumerate() {
        for &second in &parameters[place + 1..] {
            let alike = first.is_factor()
                && second.is_factor()
                && first.is_around() == second.is_around()
                && first.meets(second);
            if first == second || alike {
                return Err(CalibrationError::Twice(first, second));
            }
        }
    }
    check_finite(readings)?;
    for kind in ErrorKind::ALL {
        let mut readings =
            readings.iter().filter(|reading| reading.channel.error() == kind).peekable();
        if readings.peek().is_some() && readings.all(|reading| reading.value == 0.0) {
            return Err(CalibrationError::AllZero(kind));
        }
    }
    let (readings, parameters) = (readings.len(), parameters.len());
    match readings < parameters {
        true => Err(CalibrationError::TooFew { readings, parameters }),
        false => Ok(()),
    }
}

fn check_finite(readings: &[Reading]) -> Result<(), CalibrationError> {
    for &Reading { channel, bit_depth_m, value, .. } in readings {
        if !value.is_finite() || !bit_depth_m.is_finite() {
            return Err(CalibrationError::NotFinite { channel, bit_depth_m });
        }
    }
    Ok(())
}

fn square(count: usize, value_at: impl Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
    (0..count).map(|a| (0..count).map(|b| value_at(a, b)).collect()).collect()
}

fn estimates(
    likelihood: &Likelihood<'_>,
    best: &Best,
    spread: &Spread,
    all: &Spread,
    interval_factor: f64,
) -> Result<Vec<Estimate>, CalibrationError> {
    let parameters = &likelihood.settings.parameters;
    let estimate = |(index, &parameter): (usize, &Parameter)| {
        let at_bound = best.at_bound[index];
        let scale = if at_bound { all.standard_error(index) } else { spread.standard_error(index) };
        let span = match parameter.is_factor() {
            true => best.surfaces.span[index],
            false => [0.0, f64::INFINITY],
        };
        let along = Along { likelihood, values: &best.values, index, standard_error: scale, span };
        let value = best.values[index];
        let (interval, profile) = if likelihood.settings.profiles {
            let grown = interval_factor * interval_factor;
            (along.ends(grown)?, along.points()?)
        } else {
            let ends =
                [(value - interval_factor * scale).max(0.0), value + interval_factor * scale];
            (ends.map(Some), Vec::new())
        };
        let standard_error = (!at_bound).then_some(scale);
        Ok(Estimate { parameter, value, standard_error, interval, at_bound, profile })
    };
    parameters.iter().enumerate().map(estimate).collect()
}

fn confused(settings: &Settings, spread: &Spread) -> Vec<Confused> {
    let parameters = &settings.parameters;
    let mut pairs = Vec::new();
    for (a, &first) in parameters.iter().enumerate() {
        for (b, &second) in parameters.iter().enumerate().skip(a + 1) {
            let correlation = spread.correlation(a, b);
            if correlation.abs() > settings.correlated_beyond {
                pairs.push(Confused { first, second, correlation });
            }
        }
    }
    pairs
}

fn errors(likelihood: &Likelihood<'_>, best: &Best) -> Vec<ReadingError> {
    let residuals = likelihood.residuals(&best.values);
    let reading_error = |kind: ErrorKind| {
        let rows = residuals.iter().zip(likelihood.readings);
        let squares = rows.filter(|(_, reading)| reading.channel.error() == kind);
        let squares: Vec<f64> = squares.map(|(residual, _)| residual * residual).collect();
        let value = best.errors[kind.place()];
        (!squares.is_empty()).then(|| ReadingError {
            kind,
            value,
            given: likelihood.settings.errors[kind.place()].is_some(),
            readings: squares.len(),
            chi2: squares.iter().sum(),
        })
    };
    ErrorKind::ALL.into_iter().filter_map(reading_error).collect()
}

fn log_likelihood(likelihood: &Likelihood<'_>, chi2: f64) -> f64 {
    let log_norm = |reading: &Reading| {
        libm::log(likelihood.error_of(reading)) + 0.5 * libm::log(std::f64::consts::TAU)
    };
    -0.5 * chi2 - likelihood.readings.iter().map(log_norm).sum::<f64>()
}

fn points(
    likelihood: &Likelihood<'_>,
    best: &Best,
    spread: &Spread,
    band_factor: f64,
) -> Vec<Point> {
    let predictions = likelihood.predictions(&best.values);
    let point = |(row, reading): (usize, &Reading)| {
        let error = likelihood.error_of(reading);
        let leverage = spread.leverage[row];
        let predicted = predictions[row].0;
        let residual = reading.value - predicted;
        let standardised = residual / (error * (1.0 - leverage).max(1e-6).sqrt());
        let reading_half_width = band_factor * error * (1.0 + leverage).sqrt();
        Point {
            reading: *reading,
            predicted,
            predicted_error: error * leverage.sqrt(),
            reading_half_width,
            standardised,
            outlier: standardised.abs() > likelihood.settings.outlier_beyond,
            within_band: residual.abs() <= reading_half_width,
        }
    };
    likelihood.readings.iter().enumerate().map(point).collect()
}

/// Returns the held-out readings with their predictions from the others, and the number of strings
/// that were solved.
fn held_out_points(
    model: &impl Predict,
    settings: &Settings,
    readings: &[Reading],
    best: &Best,
    spread: &Spread,
    band_factor: f64,
) -> Result<(Vec<Point>, usize), CalibrationError> {
    let mut depths: Vec<(usize, f64)> = Vec::new();
    for reading in readings {
        let at = (reading.setup, reading.bit_depth_m);
        if !depths.contains(&at) {
            depths.push(at);
        }
    }
    if depths.is_empty() {
        return Ok((Vec::new(), 0));
    }
    let (bands, strings) = bands(model, settings, readings, &depths, best, spread, band_factor)?;
    let point = |reading: &Reading| {
        let is = |band: &&BandPoint| {
            (band.setup, band.bit_depth_m, band.channel)
                == (reading.setup, reading.bit_depth_m, reading.channel)
        };
        let band = bands.iter().find(is)?;
        let residual = reading.value - band.predicted;
        let standardised = residual * band_factor / band.reading_half_width;
        Some(Point {
            reading: *reading,
            predicted: band.predicted,
            predicted_error: band.mean_half_width / band_factor,
            reading_half_width: band.reading_half_width,
            standardised,
            outlier: standardised.abs() > settings.outlier_beyond,
            within_band: residual.abs() <= band.reading_half_width,
        })
    };
    Ok((readings.iter().filter_map(point).collect(), strings))
}

/// Returns predictions at depths, with their bands from the derivatives there, and the number of
/// strings that were solved.
fn bands(
    model: &impl Predict,
    settings: &Settings,
    readings: &[Reading],
    depths: &[(usize, f64)],
    best: &Best,
    spread: &Spread,
    band_factor: f64,
) -> Result<(Vec<BandPoint>, usize), CalibrationError> {
    let read_on_bottom = readings.iter().any(|reading| reading.channel == Channel::OnBottomTorque);
    let channels: Vec<Channel> = Channel::ALL
        .into_iter()
        .filter(|channel| read_on_bottom || *channel != Channel::OnBottomTorque)
        .collect();
    let motions: Vec<Motion> = Motion::ALL
        .into_iter()
        .filter(|motion| channels.iter().any(|channel| channel.motion() == *motion))
        .collect();
    let at_depth = |&(setup, depth): &(usize, f64)| {
        motions.iter().map(move |&motion| (setup, depth, motion)).collect::<Vec<_>>()
    };
    let stations: Vec<Station> = depths
        .iter()
        .flat_map(at_depth)
        .map(|(setup, depth, motion)| Station::new(model, settings, setup, depth, motion))
        .collect();
    let reach = |place: usize| {
        let reach = SLOPE_PART * spread.standard_error(place);
        // NaN becomes the least value.
        let reach = reach.clamp(LEAST_SLOPE, LARGEST_SLOPE).max(LEAST_SLOPE);
        [(best.values[place] - reach).max(0.0), best.values[place] + reach]
    };
    let mut requests = Vec::new();
    for station in &stations {
        requests.push(station.asked(settings, &best.values));
        for &place in &station.rubs_by {
            for value in reach(place) {
                let mut values = best.values.clone();
                values[place] = value;
                requests.push(station.asked(settings, &values));
            }
        }
    }
    let loads = model.loads(&requests)?;
    let mut loads = loads.iter().map(|load| [load.hook_load_N, load.torque_N_m]);
    let mut next = || loads.next().unwrap_or([f64::NAN; 2]);
    let mut bands = Vec::new();
    let beside = settings.state(&best.values);
    for station in &stations {
        let here = next();
        let mut slopes = vec![[0.0; 2]; best.values.len()];
        for &place in &station.rubs_by {
            let [from, to] = reach(place);
            let (low, high) = (next(), next());
            slopes[place] = [0, 1].map(|part| (high[part] - low[part]) / (to - from));
        }
        for &channel in channels.iter().filter(|channel| channel.motion() == station.motion) {
            let part = usize::from(channel.is_torque());
            let mut slopes: Vec<f64> = slopes.iter().map(|slope| slope[part]).collect();
            let (added, by) = match channel {
                Channel::OnBottomTorque => (beside.bit_torque_N_m, Some(Parameter::BitTorque)),
                Channel::OffBottomTorque => (0.0, None),
                _ => (beside.block_weight_N, Some(Parameter::BlockWeight)),
            };
            for (slope, parameter) in slopes.iter_mut().zip(&settings.parameters) {
                if by == Some(*parameter) {
                    *slope = 1.0;
                }
            }
            let variance = spread.variance(&slopes);
            let error = best.errors[channel.error().place()];
            bands.push(BandPoint {
                setup: station.setup,
                bit_depth_m: station.bit_depth_m,
                channel,
                predicted: here[part] + added,
                mean_half_width: band_factor * variance.sqrt(),
                reading_half_width: band_factor * (variance + error * error).sqrt(),
            });
        }
    }
    Ok((bands, requests.len()))
}
