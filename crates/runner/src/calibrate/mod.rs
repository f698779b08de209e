//! Friction factors, block weight and torque on bit from readings at the surface.

mod checks;
mod dynamic;
mod fit;
mod notes;
pub mod option;
mod outliers;
mod page;
mod predictions;
mod request;
mod search;
mod settings;
mod tables;
mod toml;

pub use crate::readings::NamedCase;
pub(crate) use checks::{of_comparison, sentences};
pub use dynamic::CheckDynamics;
pub use fit::Fit;
pub use request::{Outcome, Request, run};
pub use toml::{FRAGMENT, changes};
pub use wholestring_plan::calibration::Parameter;
