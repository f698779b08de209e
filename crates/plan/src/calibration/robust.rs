//! Outliers among readings, by a robust fit.
//!
//! Least squares give a wrong reading the more weight the farther it is off, and errors that are
//! estimated from the residuals grow with it until it is no longer an outlier. Huber's loss is
//! quadratic up to 1.345 scales and linear beyond; the scale of each kind of readings is the median
//! of the absolute residuals, which fewer than half of them cannot move (P. J. Huber, *Robust
//! Statistics*, 1981; P. J. Rousseeuw and A. M. Leroy, *Robust Regression and Outlier Detection*,
//! 1987, for the factor of small samples).

use super::{
    CalibrationError, ErrorKind, Predict, Reading, Settings,
    fit::Likelihood,
    solve::check,
    surface::{Surfaces, stations},
};

/// Name of the loss, for people.
pub const LOSS: &str = "Huber";

/// Number of scales beyond which the loss is linear: 95 % as efficient as least squares where
/// errors are normal.
const CORNER: f64 = 1.345;

/// Scales of normal errors over the median of their absolute values.
const NORMAL: f64 = 1.4826;

/// Initial scales, and their lower limits, by [`ErrorKind`]: parts of the readings' median.
const FIRST_SCALE: [f64; 3] = [0.02, 0.02, 0.05];
const LEAST_SCALE: [f64; 3] = [0.005, 0.005, 0.01];

/// Maximum number of rounds of weights and scales, and the relative change at which they have
/// converged.
const ROUNDS: usize = 60;
const CHANGE: f64 = 1e-4;

/// Approximate uncertainty factor of a scale from this few readings.
const UNSURE: f64 = 1.2;

/// Largest part of the readings that may be outliers; a larger part means that the model is wrong.
const MOST: f64 = 0.25;

/// Readings that a robust fit excludes.
#[derive(Debug, Clone, PartialEq)]
pub struct Outliers {
    /// Whether each reading is an outlier; all `false` where there are too many.
    pub outlier: Vec<bool>,
    /// Number of candidates, where that is more than a quarter of all.
    pub too_many: Option<usize>,
    /// Scales of the residuals by [`ErrorKind::place`], N or N·m.
    pub scales: [f64; 3],
    /// The values of the parameters that the robust fit has.
    pub values: Vec<f64>,
}

/// Finds the readings whose residuals exceed 1.2 times [`Settings::outlier_beyond`] scales in a fit
/// with Huber's loss: a scale from this few readings is uncertain by about a fifth.
///
/// # Errors
/// Readings that do not determine the parameters, or a string for which the model has no solution.
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
        let readings = readings.iter().filter(|reading| reading.channel.error() == kind);
        median(readings.map(|reading| reading.value.abs()).collect())
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
    let start = |parameter: &super::Parameter| if parameter.is_factor() { 0.25 } else { 0.0 };
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
            let sizes = readings.iter().zip(&residuals);
            let sizes = sizes.filter(|(reading, _)| reading.channel.error() == kind);
            let sizes: Vec<f64> = sizes.map(|(_, residual)| residual.abs()).collect();
            if sizes.is_empty() {
                continue;
            }
            let freedom = sizes.len().saturating_sub(parameters).max(1) as f64;
            let scale = NORMAL * (1.0 + 5.0 / freedom) * median(sizes) * likelihood.errors[place];
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
