//! Builds the parts of a run from model, operation and settings.

pub mod basis;
pub mod chain;
pub mod foreseen;

use crate::{
    dynamics::settings::schedule::ScheduleFault, rock::DrillingError, statics::soft::SoftError,
};

// Why a run cannot begin.

/// Why a run cannot begin.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SetupError {
    /// The soft string, from which the start is prepared, has no solution.
    #[error("the string cannot be placed in the hole: {0}")]
    Start(#[from] SoftError),
    /// A setting that no run can use.
    #[error("{name} is {value}, expected {expected}")]
    Setting {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Expected value or range.
        expected: &'static str,
    },
    /// A bit and solid rock that cannot be.
    #[error(transparent)]
    Rock(#[from] DrillingError),
    /// A bit that is lighter than the rock that it touches.
    #[error(
        "the bit's node has {bit:.3} {unit} {direction} and the rock that it touches up to \
         {rock:.3} {unit}, expected less: \
         lower the density factor or the size of the elements, or raise the length of the elements"
    )]
    LightBit {
        /// In which direction.
        direction: &'static str,
        /// Unit of the two.
        unit: &'static str,
        /// Of the bit's node.
        bit: f64,
        /// Of the rock.
        rock: f64,
    },
    /// A bit that cannot leave its hole's axis, on solid rock that holds it by itself.
    #[error(
        "the bit is held on the hole's axis, and solid rock under it would push it off: expected \
         an end that is held by its lateral stiffness, or a free one"
    )]
    BitEnd,
    /// An excitation of the caller's own under a law that has no rock front to shake.
    #[error("the excitation of the bit does not act under its law: {0}")]
    Excitation(&'static str),
    /// Single precision, where it does not serve.
    #[error("single precision does not serve here: {0}")]
    Precision(&'static str),
    /// A schedule that cannot be followed.
    #[error("line {line} of the schedule: {fault}")]
    Schedule {
        /// Which line, counted from one.
        line: usize,
        /// Fault of the schedule.
        fault: ScheduleFault,
    },
    /// The [executor](crate::rock::Executor::stopped) requested a stop before the first step.
    #[error("stopped before the first step")]
    Stopped,
}

// Numbers that a run can use.

/// Refuses numbers, each with its name: those that must be positive, and those that may be zero.
pub(super) fn check_numbers(
    positive: &[(&'static str, f64)],
    not_negative: &[(&'static str, f64)],
) -> Result<(), SetupError> {
    let wrong = |value: f64, enough: bool| !(value.is_finite() && enough);
    for &(name, value) in positive {
        if wrong(value, value > 0.0) {
            return Err(SetupError::Setting { name, value, expected: "a positive number" });
        }
    }
    for &(name, value) in not_negative {
        if wrong(value, value >= 0.0) {
            return Err(SetupError::Setting { name, value, expected: "zero or a positive number" });
        }
    }
    Ok(())
}
