//! The best fit, with the errors of readings whose errors are not given.

use super::{
    CalibrationError, ErrorKind, HolePart, Predict, Reading, Settings,
    fit::Likelihood,
    settings::LARGEST_FACTOR,
    spread::Spread,
    surface::{Station, Surfaces},
};

/// How often errors are estimated anew, and when they stand.
const ERROR_ROUNDS: usize = 60;
const ERROR_CHANGE: f64 = 1e-7;

/// How often predictions are made anew, on a box that suits the fit better.
const BOX_ROUNDS: usize = 6;

/// Predictions between nodes may be off by this part of a reading's error.
const INTERPOLATION: f64 = 0.02;

/// How often the box is made wider for the intervals after that, and how far beyond their ends by the standard
/// error: profiles are not parabolas.
const WIDER_ROUNDS: usize = 2;
const WIDER: f64 = 1.4;

/// A narrower box reaches so many standard errors and so far at least.
const REACH: f64 = 6.0;
const LEAST_REACH: f64 = 0.02;

/// Readings of a kind have this many degrees of freedom, or their error is not estimated.
const LEAST_FREEDOM: f64 = 0.5;

/// Where the fit begins.
const FIRST_FACTOR: f64 = 0.25;

/// The best fit.
pub(super) struct Best {
    pub(super) values: Vec<f64>,
    pub(super) at_bound: Vec<bool>,
    /// By kind; NaN of kinds without readings whose error is not given.
    pub(super) errors: [f64; 3],
    pub(super) surfaces: Surfaces,
    pub(super) interpolation_error: f64,
    pub(super) strings: usize,
}

/// Fits, on a box of factors that holds the answer and is narrow enough.
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
    let start = |of: &super::Parameter| match of.is_factor() {
        true => FIRST_FACTOR.clamp(from, to),
        false => 0.0,
    };
    let mut values: Vec<f64> = parameters.iter().map(start).collect();
    let mut errors = first_errors(settings, readings);
    let mut strings = 0;
    let mut round = 0;
    // A fit that stands, in a box that its intervals leave: its answer where a wider box has none.
    let mut narrow: Option<Best> = None;
    let mut widened = 0;
    loop {
        round += 1;
        let counted = Counted { model, strings: Default::default() };
        let surfaces = match Surfaces::new(&counted, settings, stations, span.clone()) {
            Ok(surfaces) => surfaces,
            Err(error) if error.is_interruption() => return Err(error),
            Err(error) => return narrow.take().ok_or(error),
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
        let outside = |of: usize| {
            let [from, to] = surfaces.span[of];
            parameters[of].is_factor() && (values[of] > to || (values[of] < from && !at_bound[of]))
        };
        if let Some(of) = (0..values.len()).find(|&of| outside(of)) {
            strings += counted.strings.get();
            if let Some(narrow) = narrow.take() {
                return Ok(Best { strings, ..narrow });
            }
            if values[of] > LARGEST_FACTOR || round >= BOX_ROUNDS {
                let limit = surfaces.span[of][1].max(LARGEST_FACTOR.min(values[of]));
                return Err(CalibrationError::Beyond { parameter: parameters[of], limit });
            }
            for (of, span) in span.iter_mut().enumerate() {
                let half = 0.5 * (span[1] - span[0]);
                if parameters[of].is_factor() && outside(of) {
                    let middle = values[of].max(half);
                    *span = [(middle - half).max(0.0), (middle + half).min(1.2 * LARGEST_FACTOR)];
                }
            }
            continue;
        }
        let asked: Vec<_> =
            stations.iter().map(|station| station.asked(settings, &values)).collect();
        let exact = counted.loads(&asked)?;
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
            let reach = |of: usize| WIDER * interval_factor * all.standard_error(of);
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
        for (of, span) in span.iter_mut().enumerate() {
            if parameters[of].is_factor() {
                let width = 0.5 * (span[1] - span[0]);
                let reach = (REACH * spread.standard_error(of)).max(LEAST_REACH).min(0.6 * width);
                *span = [(values[of] - reach).max(0.0), values[of].max(0.0) + reach];
            }
        }
    }
}

/// A box that the intervals of the factors lie in, where this one is too narrow for them.
fn wider(
    parameters: &[super::Parameter],
    span: &[[f64; 2]],
    values: &[f64],
    reach: impl Fn(usize) -> f64,
) -> Option<Vec<[f64; 2]>> {
    let wide = |of: usize| {
        let [from, to] = span[of];
        let low = (values[of] - reach(of)).max(0.0).min(from);
        let high = (values[of] + reach(of)).min(LARGEST_FACTOR).max(to);
        if parameters[of].is_factor() && high.is_finite() { [low, high] } else { [from, to] }
    };
    let wide: Vec<[f64; 2]> = (0..values.len()).map(wide).collect();
    (wide != span).then_some(wide)
}

/// A model whose answers are counted.
struct Counted<'a, M> {
    model: &'a M,
    strings: std::cell::Cell<usize>,
}

impl<M: Predict> Predict for Counted<'_, M> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.model.reaches(setup, bit_depth_m, part)
    }

    fn loads(&self, asked: &[super::Asked]) -> Result<Vec<super::Loads>, CalibrationError> {
        self.strings.set(self.strings.get() + asked.len());
        self.model.loads(asked)
    }
}

/// Errors to begin with: as given, or a part of what is read.
fn first_errors(settings: &Settings, readings: &[Reading]) -> [f64; 3] {
    ErrorKind::ALL.map(|kind| {
        let of = readings.iter().filter(|reading| reading.channel.error() == kind);
        let values: Vec<f64> = of.map(|reading| reading.value.abs()).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        settings.errors[kind.place()].unwrap_or(0.05 * mean)
    })
}

/// The fit by turns with the errors that are not given: each is the root of the mean square of its
/// residuals, over the readings less the parameters that they pay for.
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
            let of: Vec<usize> = (0..residuals.len())
                .filter(|&row| likelihood.readings[row].channel.error() == kind)
                .collect();
            if settings.errors[kind.place()].is_some() || of.is_empty() {
                continue;
            }
            let freedom: f64 = of.iter().map(|&row| 1.0 - spread.leverage[row]).sum();
            let squares: f64 = of.iter().map(|&row| residuals[row].powi(2)).sum();
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
