//! What is looked for, and how.

use super::{AroundRatio, ErrorKind, Parameter, State};

/// What is looked for, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// The numbers that are looked for.
    pub parameters: Vec<Parameter>,
    /// All numbers where they are not looked for.
    pub held: State,
    /// Friction around the hole in its ratio to that along it, where it is not looked for itself.
    pub around_ratio: AroundRatio,
    /// Whether rotational friction is looked for itself.
    pub around_apart: bool,
    /// Standard error of each kind of reading, N or N·m, by [`ErrorKind::place`]; estimated where
    /// none is given.
    pub errors: [Option<f64>; ErrorKind::ALL.len()],
    /// Whether the likelihood is followed along each parameter; without that the intervals are those of
    /// the standard errors.
    pub profiles: bool,
    /// Confidence of the intervals.
    pub confidence: f64,
    /// Confidence of the bands.
    pub band_confidence: f64,
    /// An outlier's residual is larger than so many of its own standard errors.
    pub outlier_beyond: f64,
    /// Two numbers are not told apart where their correlation is beyond this.
    pub correlated_beyond: f64,
    /// Factors between which the predictions are made at first.
    pub first_box: [f64; 2],
    /// Nodes of a factor at which predictions are made.
    pub nodes: usize,
}

/// Largest friction factor that a case takes.
pub(super) const LARGEST_FACTOR: f64 = 2.0;

impl Settings {
    /// To look for some numbers, the others being held.
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

    /// Holds a number that was looked for.
    pub fn hold(&mut self, parameter: Parameter, value: f64) {
        let ratio = self.around_follows().then_some(self.around_ratio);
        parameter.set(&mut self.held, value, ratio.as_ref());
        self.parameters.retain(|of| *of != parameter);
    }

    /// Whether rotational friction goes with that along it.
    pub fn around_follows(&self) -> bool {
        !self.around_apart
    }

    /// All numbers, some of which are as given.
    pub fn state(&self, values: &[f64]) -> State {
        let mut state = self.held;
        let ratio = self.around_follows().then_some(&self.around_ratio);
        for (parameter, &value) in self.parameters.iter().zip(values) {
            parameter.set(&mut state, value, ratio);
        }
        state
    }
}
