//! The whole string in time: 3D nonlinear rod, wall contact and friction, top drive, hoist and bit.

mod assembly;
mod bit;
mod chain;
mod energy;
mod hoist;
mod outcome;
mod record;
mod settings;
mod setup;
mod simulation;
mod start;
mod step;
mod summary;
#[cfg(test)]
mod tests;
mod viscous;

pub use energy::EnergyBalance;
pub use outcome::{DynamicOutcome, NodeProfile, Numerics, Statistic, TimeSeries};
pub use settings::{
    BitSettings, ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, HoistLine, RodDamping,
    Start,
};
pub use setup::{Effort, SetupError};
pub use simulation::{Diverged, Simulation};
