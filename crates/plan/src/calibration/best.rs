//! The best fit, with the errors of readings whose errors are not given.

use super::{
    CalibrationError, ErrorKind, HolePart, Predict, Reading, Settings,
    fit::Likelihood,
    settings::LARGEST_FACTOR,
    spread::Spread,
    surface::{Station, Surfaces},
};

/// Maximum number of estimates of the errors, and the relative change at which they have converged.
const ERROR_ROUNDS: usize = 60;
const ERROR_CHANGE: f64 = 1e-7;

/// Maximum number of recomputations of the predictions, on a box that suits the fit better.
const BOX_ROUNDS: usize = 6;

/// Tolerance of predictions between nodes, as a part of a reading's error.
const INTERPOLATION: f64 = 0.02;

/// Number of subsequent extensions of the box for the intervals, and their distance beyond the ends
/// by the standard error, because profiles are not parabolas.
const WIDER_ROUNDS: usize = 2;
const WIDER: f64 = 1.4;

/// Half width of a narrower box in standard errors, and its least value.
const REACH: f64 = 6.0;
const LEAST_REACH: f64 = 0.02;

/// Least number of degrees of freedom of readings of a kind for an estimate of their error.
const LEAST_FREEDOM: f64 = 0.5;

/// Initial friction factor of the fit.
const FIRST_FACTOR: f64 = 0.25;

/// The best fit.
pub(super) struct Best {
    pub(super) values: Vec<f64>,
    pub(super) at_bound: Vec<bool>,
    /// Errors by kind; NaN for kinds without readings whose error is not given.
    pub(super) errors: [f64; 3],
    pub(super) surfaces: Surfaces,
    pub(super) interpolation_error: f64,
    pub(super) strings: usize,
}

/// Fits the parameters on a box of factors that contains the solution and is narrow enough.
pub(super) fn best(
    model: &impl Predict,
    settings: &Settings,
    readings: &[Reading],
    (stations, station_of): (&[Station], &[usize]),
    interval_factor: f64,
) -> Result<Best, CalibrationError> {
    let parameters = &settings.parameters;
    let mut span = vec![settings.first_box; parameters.len()];
    let [from, to] = settings.first_box;
    let start = |parameter: &super::Parameter| match parameter.is_factor() {
        true => FIRST_FACTOR.clamp(from, to),
        false => 0.0,
    };
    let mut values: Vec<f64> = parameters.iter().map(start).collect();
    let mut errors = first_errors(settings, readings);
    let mut strings = 0;
    let mut round = 0;
    // A converged fit whose intervals leave its box: the result where a wider box has none.
    let mut narrow: Option<Best> = None;
    let mut widened = 0;
    // The factor that left the last box, with its value there.
    let mut runaway = None;
    loop {
        round += 1;
        let counted = Counted { model, strings: Default::default() };
        let surfaces = match Surfaces::new(&counted, settings, stations, span.clone()) {
            Ok(surfaces) => surfaces,
            Err(error) if error.is_interruption() => return Err(error),
            Err(error) => {
                let error = match runaway {
                    Some((runaway, value)) => {
                        let parameters = parameters.clone();
                        CalibrationError::Undetermined { parameters, runaway, value }
                    }
                    None => error,
                };
                return narrow.take().ok_or(error);
            }
        };
        let mut likelihood = Likelihood {
            settings,
            surfaces: &surfaces,
            readings,
            station_of,
            errors,
            weights: Vec::new(),
        };
        let (found, at_bound, spread) = with_errors(&mut likelihood, &values)?;
        let all = Spread::of(&likelihood.design(&found), &vec![false; found.len()], settings)?;
        errors = likelihood.errors;
        values = found;
        let outside = |index: usize| {
            let [from, to] = surfaces.span[index];
            parameters[index].is_factor()
                && (values[index] > to || (values[index] < from && !at_bound[index]))
        };
        if let Some(index) = (0..values.len()).find(|&index| outside(index)) {
            strings += counted.strings.get();
            if let Some(narrow) = narrow.take() {
                return Ok(Best { strings, ..narrow });
            }
            if values[index] > LARGEST_FACTOR || round >= BOX_ROUNDS {
                let limit = surfaces.span[index][1].max(LARGEST_FACTOR.min(values[index]));
                return Err(CalibrationError::Beyond { parameter: parameters[index], limit });
            }
            runaway = Some((parameters[index], values[index]));
            for (index, span) in span.iter_mut().enumerate() {
                let half = 0.5 * (span[1] - span[0]);
                if parameters[index].is_factor() && outside(index) {
                    let middle = values[index].max(half);
                    *span = [(middle - half).max(0.0), (middle + half).min(1.2 * LARGEST_FACTOR)];
                }
            }
            continue;
        }
        let requests: Vec<_> =
            stations.iter().map(|station| station.asked(settings, &values)).collect();
        let exact = counted.loads(&requests)?;
        strings += counted.strings.get();
        let between = surfaces.at(&values);
        let off = |(reading, &station): (&Reading, &usize)| {
            let (exact, between) = (exact[station], between[station].loads);
            let apart = match reading.channel.is_torque() {
                true => exact.torque_N_m - between[1],
                false => exact.hook_load_N - between[0],
            };
            apart.abs() / errors[reading.channel.error().place()]
        };
        let interpolation_error = readings.iter().zip(station_of).map(off).fold(0.0, f64::max);
        if interpolation_error <= INTERPOLATION || round >= BOX_ROUNDS {
            let reach = |index: usize| WIDER * interval_factor * all.standard_error(index);
            let wider = wider(parameters, &surfaces.span, &values, reach)
                .filter(|_| settings.profiles && widened < WIDER_ROUNDS);
            let best = Best { values, at_bound, errors, surfaces, interpolation_error, strings };
            let Some(wider) = wider else { return Ok(best) };
            widened += 1;
            span = wider;
            values = best.values.clone();
            narrow = Some(best);
            continue;
        }
        for (index, span) in span.iter_mut().enumerate() {
            if parameters[index].is_factor() {
                let width = 0.5 * (span[1] - span[0]);
                let reach =
                    (REACH * spread.standard_error(index)).max(LEAST_REACH).min(0.6 * width);
                *span = [(values[index] - reach).max(0.0), values[index].max(0.0) + reach];
            }
        }
    }
}

/// Returns a box that contains the intervals of the factors, where this one is too narrow for them.
fn wider(
    parameters: &[super::Parameter],
    span: &[[f64; 2]],
    values: &[f64],
    reach: impl Fn(usize) -> f64,
) -> Option<Vec<[f64; 2]>> {
    let wide = |index: usize| {
        let [from, to] = span[index];
        let low = (values[index] - reach(index)).max(0.0).min(from);
        let high = (values[index] + reach(index)).min(LARGEST_FACTOR).max(to);
        if parameters[index].is_factor() && high.is_finite() { [low, high] } else { [from, to] }
    };
    let wide: Vec<[f64; 2]> = (0..values.len()).map(wide).collect();
    (wide != span).then_some(wide)
}

/// A model that counts its solutions.
struct Counted<'a, M> {
    model: &'a M,
    strings: std::cell::Cell<usize>,
}

impl<M: Predict> Predict for Counted<'_, M> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.model.reaches(setup, bit_depth_m, part)
    }

    fn loads(&self, requests: &[super::Asked]) -> Result<Vec<super::Loads>, CalibrationError> {
        self.strings.set(self.strings.get() + requests.len());
        self.model.loads(requests)
    }
}

/// Returns the initial errors: as given, or a part of the readings.
fn first_errors(settings: &Settings, readings: &[Reading]) -> [f64; 3] {
    ErrorKind::ALL.map(|kind| {
        let readings = readings.iter().filter(|reading| reading.channel.error() == kind);
        let values: Vec<f64> = readings.map(|reading| reading.value.abs()).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        settings.errors[kind.place()].unwrap_or(0.05 * mean)
    })
}

/// Alternates the fit with estimates of the errors that are not given: each is the root of the mean
/// square of its residuals, over the number of readings less their share of the parameters.
pub(super) fn with_errors(
    likelihood: &mut Likelihood<'_>,
    from: &[f64],
) -> Result<(Vec<f64>, Vec<bool>, Spread), CalibrationError> {
    let settings = likelihood.settings;
    let free = vec![None; from.len()];
    let mut values = from.to_vec();
    for round in 0.. {
        let (found, at_bound) = likelihood.fit(&values, &free)?;
        values = found;
        let spread = Spread::of(&likelihood.design(&values), &at_bound, settings)?;
        let residuals = likelihood.residuals(&values);
        let mut change: f64 = 0.0;
        let mut errors = likelihood.errors;
        for kind in ErrorKind::ALL {
            let rows: Vec<usize> = (0..residuals.len())
                .filter(|&row| likelihood.readings[row].channel.error() == kind)
                .collect();
            if settings.errors[kind.place()].is_some() || rows.is_empty() {
                continue;
            }
            let freedom: f64 = rows.iter().map(|&row| 1.0 - spread.leverage[row]).sum();
            let squares: f64 = rows.iter().map(|&row| residuals[row].powi(2)).sum();
            let ratio = (squares / freedom).sqrt();
            if freedom < LEAST_FREEDOM || !(ratio > 1e-9 && ratio.is_finite()) {
                return Err(CalibrationError::UnknownError(kind));
            }
            errors[kind.place()] *= ratio;
            change = change.max((ratio - 1.0).abs());
        }
        if change < ERROR_CHANGE || round == ERROR_ROUNDS {
            return Ok((values, at_bound, spread));
        }
        likelihood.errors = errors;
    }
    unreachable!("the rounds are counted")
}
