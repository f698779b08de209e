//! Settings of a calibration.

use super::{AroundRatio, ErrorKind, Parameter, State};

/// Settings of a calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// The fitted parameters.
    pub parameters: Vec<Parameter>,
    /// Values of the parameters that are not fitted.
    pub held: State,
    /// Friction around the hole in its ratio to that along it, where it is not fitted itself.
    pub around_ratio: AroundRatio,
    /// Whether rotational friction is fitted separately.
    pub around_apart: bool,
    /// Standard error of each kind of reading, N or N·m, by [`ErrorKind::place`]; estimated where
    /// none is given.
    pub errors: [Option<f64>; ErrorKind::ALL.len()],
    /// Whether the likelihood is computed along each parameter; otherwise the intervals are those
    /// of the standard errors.
    pub profiles: bool,
    /// Confidence of the intervals.
    pub confidence: f64,
    /// Confidence of the bands.
    pub band_confidence: f64,
    /// Number of its own standard errors beyond which a residual is an outlier.
    pub outlier_beyond: f64,
    /// Correlation beyond which two parameters count as inseparable.
    pub correlated_beyond: f64,
    /// Initial range of factors for the predictions.
    pub first_box: [f64; 2],
    /// Nodes of a factor at which predictions are made.
    pub nodes: usize,
}

/// Largest friction factor of a case.
pub(super) const LARGEST_FACTOR: f64 = 2.0;

impl Settings {
    /// Returns settings to fit some parameters with the others fixed.
    pub fn new(parameters: Vec<Parameter>, held: State) -> Self {
        let around_apart = parameters.iter().any(|parameter| parameter.is_around());
        Self {
            parameters,
            held,
            around_apart,
            around_ratio: AroundRatio::default(),
            errors: [None; ErrorKind::ALL.len()],
            profiles: true,
            confidence: 0.95,
            band_confidence: 0.9,
            outlier_beyond: 3.0,
            correlated_beyond: 0.95,
            first_box: [0.0, 0.8],
            nodes: 5,
        }
    }

    /// Fixes a parameter that was to be fitted.
    pub fn hold(&mut self, parameter: Parameter, value: f64) {
        let ratio = self.around_follows().then_some(self.around_ratio);
        parameter.set(&mut self.held, value, ratio.as_ref());
        self.parameters.retain(|other| *other != parameter);
    }

    /// Whether rotational friction follows axial friction.
    pub fn around_follows(&self) -> bool {
        !self.around_apart
    }

    /// Returns all parameters, with some of them as given.
    pub fn state(&self, values: &[f64]) -> State {
        let mut state = self.held;
        let ratio = self.around_follows().then_some(&self.around_ratio);
        for (parameter, &value) in self.parameters.iter().zip(values) {
            parameter.set(&mut state, value, ratio);
        }
        state
    }
}
