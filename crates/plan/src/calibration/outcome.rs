//! Results of a calibration.

use super::{Channel, ErrorKind, Parameter, Reading, State};

/// A fitted parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// The parameter.
    pub parameter: Parameter,
    /// Its best value, SI.
    pub value: f64,
    /// Its standard error; `None` where the value is at its bound.
    pub standard_error: Option<f64>,
    /// The interval within which the likelihood allows it; `None` for an end that is not found.
    pub interval: [Option<f64>; 2],
    /// Whether it would be negative without the bound, and is zero.
    pub at_bound: bool,
    /// The likelihood along it, all others at their best.
    pub profile: Vec<ProfilePoint>,
}

/// The likelihood with one parameter fixed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// The fixed value.
    pub value: f64,
    /// Increase of the sum of squared residuals.
    pub excess: f64,
    /// The same increase for a parabola with the standard error.
    pub parabola: f64,
}

/// Standard error of readings of a kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadingError {
    /// The kind of readings.
    pub kind: ErrorKind,
    /// Their standard error, N or N·m.
    pub value: f64,
    /// Whether it was given, not estimated.
    pub given: bool,
    /// Number of readings.
    pub readings: usize,
    /// The sum of their squared residuals over the error.
    pub chi2: f64,
}

/// A reading and its prediction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The reading.
    pub reading: Reading,
    /// Its prediction.
    pub predicted: f64,
    /// Standard error of that prediction by those of the parameters.
    pub predicted_error: f64,
    /// Half the width of the band within which a reading lies.
    pub reading_half_width: f64,
    /// Residual, measured less predicted, over its standard error after the fit.
    pub standardised: f64,
    /// Whether the residual exceeds the range of errors of this size.
    pub outlier: bool,
    /// Whether the reading is within its band.
    pub within_band: bool,
}

/// A prediction at a depth with its band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandPoint {
    /// Index of the setup in the hole.
    pub setup: usize,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The channel.
    pub channel: Channel,
    /// Its value.
    pub predicted: f64,
    /// Half the width of the confidence band of the mean.
    pub mean_half_width: f64,
    /// Half the width of the prediction band of a reading.
    pub reading_half_width: f64,
}

/// Two parameters that the readings cannot separate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Confused {
    /// The first parameter.
    pub first: Parameter,
    /// The second parameter.
    pub second: Parameter,
    /// Their correlation.
    pub correlation: f64,
}

/// Results of a calibration of a well.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// Every fitted parameter.
    pub estimates: Vec<Estimate>,
    /// All parameters, including the fixed ones.
    pub state: State,
    /// Correlations of the estimates, a row for each.
    pub correlation: Vec<Vec<f64>>,
    /// Covariance of the estimates; zero for those at their bounds.
    pub covariance: Vec<Vec<f64>>,
    /// Condition number of the correlations: with a large one some parameters cannot be separated.
    pub condition: f64,
    /// Pairs that cannot be separated.
    pub confused: Vec<Confused>,
    /// Errors of the readings.
    pub errors: Vec<ReadingError>,
    /// Sum of the squared residuals over their errors.
    pub chi2: f64,
    /// Number of readings less number of parameters.
    pub degrees_of_freedom: usize,
    /// Logarithm of the likelihood, constants included.
    pub log_likelihood: f64,
    /// Half width of the intervals, in standard errors.
    pub interval_factor: f64,
    /// Half width of the bands, in standard errors.
    pub band_factor: f64,
    /// Every reading.
    pub points: Vec<Point>,
    /// Readings that were held out, with their predictions from the others; here the standardised
    /// residual is measured less predicted over the standard error of a prediction.
    pub held_out: Vec<Point>,
    /// Predictions with their bands, by setup, channel and depth.
    pub bands: Vec<BandPoint>,
    /// Largest error of the predictions between nodes at the best values, in errors of the
    /// readings.
    pub interpolation_error: f64,
    /// Number of strings that were solved.
    pub strings: usize,
}
