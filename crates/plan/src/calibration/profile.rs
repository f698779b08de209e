//! The likelihood along one parameter.

use super::{CalibrationError, ProfilePoint, fit::Likelihood};

/// Number of points of a profile, and its extent, standard errors.
const POINTS: usize = 25;
const REACH: f64 = 3.2;

/// Tolerance of the ends of intervals, as a part of the sought excess.
const EXACT: f64 = 1e-6;

/// A parameter along which the likelihood is computed.
pub(super) struct Along<'a> {
    pub(super) likelihood: &'a Likelihood<'a>,
    /// The best fit.
    pub(super) values: &'a [f64],
    /// Index of the parameter.
    pub(super) index: usize,
    pub(super) standard_error: f64,
    /// Range in which predictions are valid.
    pub(super) span: [f64; 2],
}

impl Along<'_> {
    /// Returns the increase of the sum of squares with the parameter fixed.
    fn excess(&self, value: f64, least: f64) -> Result<f64, CalibrationError> {
        let mut held = vec![None; self.values.len()];
        held[self.index] = Some(value);
        let mut from = self.values.to_vec();
        from[self.index] = value;
        let (values, _) = self.likelihood.fit(&from, &held)?;
        Ok((self.likelihood.chi2(&values) - least).max(0.0))
    }

    pub(super) fn points(&self) -> Result<Vec<ProfilePoint>, CalibrationError> {
        let least = self.likelihood.chi2(self.values);
        let best = self.values[self.index];
        let [lower, upper] = self.span;
        let from = (best - REACH * self.standard_error).max(lower);
        let to = (best + REACH * self.standard_error).min(upper);
        let point = |k: usize| {
            let value = from + (to - from) * k as f64 / (POINTS - 1) as f64;
            let parabola = ((value - best) / self.standard_error).powi(2);
            Ok(ProfilePoint { value, excess: self.excess(value, least)?, parabola })
        };
        (0..POINTS).map(point).collect()
    }

    /// Returns where the sum of squares has grown by this much, to either side. The lower end is
    /// zero where the growth at zero is less.
    pub(super) fn ends(&self, grown: f64) -> Result<[Option<f64>; 2], CalibrationError> {
        let least = self.likelihood.chi2(self.values);
        let best = self.values[self.index];
        let end = |sign: f64| -> Result<Option<f64>, CalibrationError> {
            let limit = if sign < 0.0 { self.span[0] } else { self.span[1] };
            let mut step = grown.sqrt() * self.standard_error;
            for _ in 0..40 {
                let mut value = best + sign * step;
                let outside = sign * (value - limit) > 0.0;
                if outside {
                    value = limit;
                    step = (limit - best).abs();
                }
                let excess = self.excess(value, least)?;
                if outside && excess < grown {
                    return Ok((sign < 0.0 && limit == 0.0).then_some(0.0));
                }
                if (excess / grown - 1.0).abs() < EXACT {
                    return Ok(Some(value));
                }
                // Nearly a parabola: the root of the excess grows with the distance.
                step *= (grown / excess.max(1e-3 * grown)).sqrt();
            }
            Ok(None)
        };
        Ok([end(-1.0)?, end(1.0)?])
    }
}
