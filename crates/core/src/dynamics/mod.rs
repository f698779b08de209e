//! The whole string in time: 3D nonlinear rod, wall contact and friction, top drive, hoist and bit.

mod assembly;
mod bit;
mod carry;
mod chain;
mod frame;
mod hoist;
mod indicators;
mod outcome;
mod record;
mod settings;
mod setup;
mod signal;
mod simulation;
mod start;
mod step;
mod summary;
#[cfg(test)]
mod tests;

pub use frame::{Channel, Frame};
pub use indicators::{Indicators, StickSlip, TorqueUse, Whirl};
pub use outcome::{
    ContactClass, DynamicOutcome, NodeProfile, Numerics, Percentiles, Statistic, TimeSeries,
};
pub use settings::{
    BitSettings, ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, HoistLine, RodDamping,
    Start,
};
pub use setup::{Effort, SetupError};
pub use signal::Signal;
pub use simulation::{Diverged, Simulation};
