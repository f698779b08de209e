//! Errors of a calibration.

use super::{Channel, ErrorKind, Parameter};

/// The reason why a calibration fails.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CalibrationError {
    /// No parameter is to be fitted.
    #[error("nothing is to be fitted: no friction factor, block weight or bit torque")]
    NothingAsked,
    /// Two parameters that are the same number.
    #[error("the {} and the {} are one number: fit one of them", .0.words(), .1.words())]
    Twice(Parameter, Parameter),
    /// More parameters than readings.
    #[error(
        "{} cannot determine {}: give more readings, or fit fewer numbers",
        counted(*.readings, "reading"), counted(*.parameters, "number")
    )]
    TooFew {
        /// Number of readings.
        readings: usize,
        /// Number of fitted parameters.
        parameters: usize,
    },
    /// A parameter that no reading depends on.
    #[error("no reading depends on the {}: keep it fixed", .0.words())]
    Untold(Parameter),
    /// The errors of readings of a kind cannot be estimated from the residuals.
    #[error(
        "the {} are too few to estimate their error from, or agree with the model to the last digit: \
         give their standard error", .0.name()
    )]
    UnknownError(ErrorKind),
    /// Readings of a kind that are all zero.
    #[error("the {} are all zero, which is not a reading: remove them", .0.name())]
    AllZero(ErrorKind),
    /// The fit exceeds the limits of a parameter.
    #[error(
        "the best fit of the {} is beyond {limit}: check the readings and the case (units, block \
         weight, mud, string)", .parameter.words()
    )]
    Beyond {
        /// The parameter.
        parameter: Parameter,
        /// Its limit.
        limit: f64,
    },
    /// The fit leaves the factors at which the model has solutions.
    #[error(
        "the readings do not determine {} at once: the fit runs off to a {} of {value:.2}, at which \
         the string has no solution. Give other readings too (pick-up, slack-off and rotating \
         weights, torque), or fit fewer numbers: one factor, a factor that is held, the block weight \
         in the case",
        listed(.parameters), .runaway.words()
    )]
    Undetermined {
        /// The fitted parameters.
        parameters: Vec<Parameter>,
        /// The one that leaves them.
        runaway: Parameter,
        /// Its value in the last fit.
        value: f64,
    },
    /// The fit does not converge.
    #[error("the fit did not converge: {0}")]
    NotFitted(String),
    /// The caller interrupted the calibration.
    #[error("interrupted")]
    Interrupted,
    /// A model has no solution.
    #[error(
        "no {model} string with the bit at {bit_depth_m:.1} m, {} with friction {along:.3} along the \
         hole and {around:.3} around it in open hole: {reason}", .motion
    )]
    NoAnswer {
        /// `soft` or `stiff`.
        model: &'static str,
        /// Measured depth of the bit, m.
        bit_depth_m: f64,
        /// The motion of the string.
        motion: &'static str,
        /// Factor of open hole along it.
        along: f64,
        /// Factor of open hole around it.
        around: f64,
        /// The reason given by the model.
        reason: String,
    },
    /// A reading that is not a finite number.
    #[error("the {} at {bit_depth_m} m is not a finite number", .channel.name())]
    NotFinite {
        /// The channel.
        channel: Channel,
        /// Measured depth of the bit, m.
        bit_depth_m: f64,
    },
}

/// A count with its noun: `1 reading`, `2 readings`.
fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// Parameters in words: `the block weight`, `the friction factor and the block weight`.
fn listed(parameters: &[Parameter]) -> String {
    let words: Vec<String> =
        parameters.iter().map(|parameter| format!("the {}", parameter.words())).collect();
    match &words[..] {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

impl CalibrationError {
    /// Whether the work was interrupted, so that it should not be tried again.
    pub(super) fn is_interruption(&self) -> bool {
        *self == Self::Interrupted
    }
}
