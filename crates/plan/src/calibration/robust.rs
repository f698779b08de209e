//! Outliers among readings, by a fit that they do not pull.
//!
//! Least squares give a wrong reading the more weight the farther it is off, and errors that are estimated from
//! the residuals grow with it until it is no outlier any more. Huber's loss is a square up to 1.345 scales and
//! a straight line beyond; the scale of each kind of readings is the median of the absolute residuals, which
//! half of them cannot move (P. J. Huber, *Robust Statistics*, 1981; P. J. Rousseeuw and A. M. Leroy, *Robust
//! Regression and Outlier Detection*, 1987, for the factor of small samples).

use super::{
    CalibrationError, ErrorKind, Predict, Reading, Settings,
    fit::Likelihood,
    solve::check,
    surface::{Surfaces, stations},
};

/// Name of the loss, for people.
pub const LOSS: &str = "Huber";

/// Beyond so many scales the loss is a straight line: 95 % as efficient as least squares where errors are
/// normal.
const CORNER: f64 = 1.345;

/// Scales of normal errors over the median of their absolute values.
const NORMAL: f64 = 1.4826;

/// Scales to begin with, and the least that they become, by [`ErrorKind`]: parts of the readings' median.
const FIRST_SCALE: [f64; 3] = [0.02, 0.02, 0.05];
const LEAST_SCALE: [f64; 3] = [0.005, 0.005, 0.01];

/// Rounds of weights and scales, and when they stand.
const ROUNDS: usize = 60;
const CHANGE: f64 = 1e-4;

/// A scale by so few readings is unsure by about this factor.
const UNSURE: f64 = 1.2;

/// Where more of the readings are outliers than this part, they are none: the model is wrong.
const MOST: f64 = 0.25;

/// Readings that a robust fit does not follow.
#[derive(Debug, Clone, PartialEq)]
pub struct Outliers {
    /// Of every reading, whether it is one; none is where too many were.
    pub outlier: Vec<bool>,
    /// How many would be, where that is more than a quarter of all.
    pub too_many: Option<usize>,
    /// Scales of the residuals by [`ErrorKind::place`], N or N·m.
    pub scales: [f64; 3],
    /// The values of the parameters that the robust fit has.
    pub values: Vec<f64>,
}

/// Finds the readings whose residuals are beyond 1.2 times [`Settings::outlier_beyond`] scales in a fit by Huber's
/// loss: a scale by so few readings is unsure by about a fifth.
///
/// # Errors
/// Readings that do not tell what is looked for, or a string that the model has no answer for.
pub fn outliers(
    model: &impl Predict,
    readings: &[Reading],
    settings: &Settings,
) -> Result<Outliers, CalibrationError> {
    check(readings, settings)?;
    let (stations, station_of) = stations(model, settings, readings);
    let span = vec![settings.first_box; settings.parameters.len()];
    let surfaces = Surfaces::new(model, settings, &stations, span)?;
    let size = |kind: ErrorKind| {
        let of = readings.iter().filter(|reading| reading.channel.error() == kind);
        median(of.map(|reading| reading.value.abs()).collect())
    };
    let part = |parts: [f64; 3]| {
        ErrorKind::ALL.map(|kind| {
            let place = kind.place();
            settings.errors[place].unwrap_or(parts[place] * size(kind))
        })
    };
    let least = part(LEAST_SCALE);
    let mut likelihood = Likelihood {
        settings,
        surfaces: &surfaces,
        readings,
        station_of: &station_of,
        errors: part(FIRST_SCALE),
        weights: Vec::new(),
    };
    let parameters = settings.parameters.len();
    let free = vec![None; parameters];
    let start = |of: &super::Parameter| if of.is_factor() { 0.25 } else { 0.0 };
    let mut values: Vec<f64> = settings.parameters.iter().map(start).collect();
    let mut residuals = Vec::new();
    for _ in 0..ROUNDS {
        let (found, _) = likelihood.fit(&values, &free)?;
        let moved = found.iter().zip(&values).map(|(a, b)| (a - b).abs() / b.abs().max(1e-3));
        let moved = moved.fold(0.0, f64::max);
        values = found;
        likelihood.weights.clear();
        // Over the scales of this round, without weights.
        residuals = likelihood.residuals(&values);
        let mut change: f64 = 0.0;
        for kind in ErrorKind::ALL {
            let place = kind.place();
            if settings.errors[place].is_some() {
                continue;
            }
            let of = readings.iter().zip(&residuals);
            let of = of.filter(|(reading, _)| reading.channel.error() == kind);
            let of: Vec<f64> = of.map(|(_, residual)| residual.abs()).collect();
            if of.is_empty() {
                continue;
            }
            let freedom = of.len().saturating_sub(parameters).max(1) as f64;
            let scale = NORMAL * (1.0 + 5.0 / freedom) * median(of) * likelihood.errors[place];
            let scale = scale.max(least[place]);
            change = change.max((scale / likelihood.errors[place] - 1.0).abs());
            for (reading, residual) in readings.iter().zip(&mut residuals) {
                if reading.channel.error() == kind {
                    *residual *= likelihood.errors[place] / scale;
                }
            }
            likelihood.errors[place] = scale;
        }
        let weight = |residual: &f64| (CORNER / residual.abs().max(1e-12)).min(1.0);
        likelihood.weights = residuals.iter().map(weight).collect();
        if moved.max(change) < CHANGE {
            break;
        }
    }
    let beyond = |residual: &f64| residual.abs() > UNSURE * settings.outlier_beyond;
    let outlier: Vec<bool> = residuals.iter().map(beyond).collect();
    let count = outlier.iter().filter(|is| **is).count();
    let many = count as f64 > MOST * readings.len() as f64;
    Ok(Outliers {
        outlier: if many { vec![false; readings.len()] } else { outlier },
        too_many: many.then_some(count),
        scales: likelihood.errors,
        values,
    })
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        count if count % 2 == 1 => values[count / 2],
        count => 0.5 * (values[count / 2 - 1] + values[count / 2]),
    }
}
