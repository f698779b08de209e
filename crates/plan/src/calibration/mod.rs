//! Friction factors, block weight and bit torque from surface measurements.
//!
//! With `y` the readings, `f(p)` the predictions of a model with the parameters `p`, `σ` the
//! standard errors of the readings, the most likely parameters minimise
//!
#![doc = include_str!("../../equations/likelihood.html")]
//!
//! Their covariance is `(JᵀJ)⁻¹` with `J = ∂f/∂p / σ`; intervals are those of the profile
//! likelihood. Theory: `docs/src/theory/calibration.md`.

mod best;
mod error;
mod fit;
mod outcome;
mod parameter;
mod predict;
mod profile;
mod quantile;
mod reading;
mod robust;
mod settings;
mod solve;
mod spread;
mod surface;

pub use error::CalibrationError;
pub use outcome::{BandPoint, Calibration, Confused, Estimate, Point, ProfilePoint, ReadingError};
pub use parameter::{AroundRatio, Factors, HolePart, MOST_SECTIONS, Parameter, State};
pub use predict::{Asked, Assembly, Loads, Predict, SoftPredictions};
pub use quantile::{normal_below, normal_within, student_within};
pub use reading::{Channel, ErrorKind, Motion, Reading};
pub use robust::{LOSS, Outliers, outliers};
pub use settings::Settings;
pub use solve::calibrate;
