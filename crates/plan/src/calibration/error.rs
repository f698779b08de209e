//! Why nothing is found.

use super::{Channel, ErrorKind, Parameter};

/// Why nothing is found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CalibrationError {
    /// Nothing is looked for.
    #[error("nothing is looked for: no friction factor, block weight or bit torque")]
    NothingAsked,
    /// Two parameters that are the same number.
    #[error("the {} and the {} are one number: look for one of them", .0.words(), .1.words())]
    Twice(Parameter, Parameter),
    /// More numbers than readings.
    #[error(
        "{readings} readings cannot tell {parameters} numbers: give more readings, or look for less"
    )]
    TooFew {
        /// How many were read.
        readings: usize,
        /// How many are looked for.
        parameters: usize,
    },
    /// A number that no reading depends on.
    #[error("no reading depends on the {}: leave it out, or hold it", .0.words())]
    Untold(Parameter),
    /// The errors of readings of a kind cannot be told from themselves.
    #[error(
        "the {} are too few to estimate their error from, or agree with the model to the last digit: \
         give their standard error", .0.name()
    )]
    UnknownError(ErrorKind),
    /// Readings of a kind that are all zero.
    #[error("the {} are all zero, which is no reading: leave them out", .0.name())]
    AllZero(ErrorKind),
    /// The fit runs away.
    #[error(
        "the {} that fits best lies beyond {limit}: the readings or the case are not what they seem \
         (units, block weight, mud, string)", .parameter.words()
    )]
    Beyond {
        /// Which number.
        parameter: Parameter,
        /// How far it may go.
        limit: f64,
    },
    /// The fit comes to no end.
    #[error("the fit did not come to an end: {0}")]
    NotFitted(String),
    /// Who asked for it does not want it any more.
    #[error("interrupted")]
    Interrupted,
    /// A model has no answer.
    #[error(
        "no {model} string with the bit at {bit_depth_m:.1} m, {} with friction {along:.3} along the \
         hole and {around:.3} around it in open hole: {reason}", .motion
    )]
    NoAnswer {
        /// `soft` or `stiff`.
        model: &'static str,
        /// Measured depth of the bit, m.
        bit_depth_m: f64,
        /// What the string does.
        motion: &'static str,
        /// Factor of open hole along it.
        along: f64,
        /// Factor of open hole around it.
        around: f64,
        /// What the model says.
        reason: String,
    },
    /// A reading that is no number.
    #[error("the {} at {bit_depth_m} m is not a finite number", .channel.name())]
    NotFinite {
        /// What was read.
        channel: Channel,
        /// Measured depth of the bit, m.
        bit_depth_m: f64,
    },
}

impl CalibrationError {
    /// Whether the work was interrupted, so that another try is not wanted.
    pub(super) fn is_interruption(&self) -> bool {
        *self == Self::Interrupted
    }
}
