//! The whole string in time: 3D nonlinear rod, wall contact and friction, top drive, hoist and bit.

mod assembly;
mod bit;
mod chain;
mod hoist;
mod outcome;
mod record;
mod schedule;
mod settings;
mod setup;
mod simulation;
mod start;
mod step;
mod summary;
#[cfg(test)]
mod tests;
mod top_drive;

pub use outcome::{DynamicOutcome, NodeProfile, Numerics, Statistic, TimeSeries};
pub use schedule::{HoistSetPoint, Schedule, ScheduleFault, ScheduleStep};
pub use settings::{
    Autodriller, BitSettings, ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, HoistLine,
    RodDamping, SpeedController, Start, TopDriveSettings,
};
pub use setup::{Effort, SetupError};
pub use simulation::{Diverged, Simulation};
