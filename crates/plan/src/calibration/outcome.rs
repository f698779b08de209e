//! What is found.

use super::{Channel, ErrorKind, Parameter, Reading, State};

/// A number that was looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Which.
    pub parameter: Parameter,
    /// Its best value, SI.
    pub value: f64,
    /// Its standard error; none where it lies at its bound.
    pub standard_error: Option<f64>,
    /// The interval within which the likelihood allows it; an end that is not found is none.
    pub interval: [Option<f64>; 2],
    /// It would be negative, and is zero.
    pub at_bound: bool,
    /// The likelihood along it, all others at their best.
    pub profile: Vec<ProfilePoint>,
}

/// The likelihood where one parameter is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// What it is held at.
    pub value: f64,
    /// How much greater the sum of squared residuals is.
    pub excess: f64,
    /// What it would be of a parabola by the standard error.
    pub parabola: f64,
}

/// How far readings of a kind err.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadingError {
    /// Which readings.
    pub kind: ErrorKind,
    /// Their standard error, N or N·m.
    pub value: f64,
    /// It was given, not estimated.
    pub given: bool,
    /// How many there are.
    pub readings: usize,
    /// The sum of their squared residuals over the error.
    pub chi2: f64,
}

/// A reading held against its prediction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// What was read.
    pub reading: Reading,
    /// What it would be.
    pub predicted: f64,
    /// Standard error of that prediction by those of the parameters.
    pub predicted_error: f64,
    /// Half the width of the band within which a reading lies.
    pub reading_half_width: f64,
    /// Residual, measured less predicted, over the standard error that it has after the fit.
    pub standardised: f64,
    /// It lies beyond what errors of this size allow.
    pub outlier: bool,
    /// It lies within the band of the readings.
    pub within_band: bool,
}

/// A prediction at a depth with its band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandPoint {
    /// Which setup is in the hole.
    pub setup: usize,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// What is predicted.
    pub channel: Channel,
    /// Its value.
    pub predicted: f64,
    /// Half the width of the band within which the mean lies.
    pub mean_half_width: f64,
    /// Half the width of the band within which a reading lies.
    pub reading_half_width: f64,
}

/// Two numbers that the readings do not tell apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Confused {
    /// One.
    pub first: Parameter,
    /// The other.
    pub second: Parameter,
    /// Their correlation.
    pub correlation: f64,
}

/// What readings tell of a well.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// Every number that was looked for.
    pub estimates: Vec<Estimate>,
    /// All numbers, those that were held too.
    pub state: State,
    /// Correlations of the estimates, a row for each.
    pub correlation: Vec<Vec<f64>>,
    /// Covariance of the estimates; zero of those that lie at their bounds.
    pub covariance: Vec<Vec<f64>>,
    /// Condition number of the correlations: a large one tells that some are not told apart.
    pub condition: f64,
    /// Pairs that are not told apart.
    pub confused: Vec<Confused>,
    /// Errors of the readings.
    pub errors: Vec<ReadingError>,
    /// Sum of the squared residuals over their errors.
    pub chi2: f64,
    /// Readings less parameters.
    pub degrees_of_freedom: usize,
    /// Logarithm of the likelihood, constants included.
    pub log_likelihood: f64,
    /// So many standard errors are either half of the intervals.
    pub interval_factor: f64,
    /// So many standard errors are either half of the bands.
    pub band_factor: f64,
    /// Every reading.
    pub points: Vec<Point>,
    /// Readings that took no part, held against what the others tell: what is standardised is measured less
    /// predicted over the standard error of a prediction.
    pub held_out: Vec<Point>,
    /// Predictions with their bands, by setup, channel and depth.
    pub bands: Vec<BandPoint>,
    /// Farthest that the predictions between nodes are off at the best values, in errors of the
    /// readings.
    pub interpolation_error: f64,
    /// How many strings were solved.
    pub strings: usize,
}
