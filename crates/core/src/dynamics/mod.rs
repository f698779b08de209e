//! The whole string in time: 3D nonlinear rod, wall contact and friction, top drive, hoist and bit.

mod assembly;
mod bent;
mod bit;
mod body;
mod carry;
mod chain;
mod crew;
mod drift;
mod energy;
mod flow_pressures;
mod frame;
mod hoist;
mod imbalance;
mod indicators;
mod layout;
mod lift;
mod outcome;
mod precision;
mod record;
mod schedule;
mod settings;
mod settling;
mod setup;
mod signal;
mod simulation;
mod start;
mod step;
mod summary;
#[cfg(test)]
mod tests;
mod top_drive;
mod viscous;
mod wear;

pub use crate::outcome::{
    ContactClass, ContactMap, HoleWear, Profile as NodeProfile, Signal, TimeSeries,
};
pub use bit::{
    Band, BitLaw, BitSettings, BitTable, Cutters, DetournayDefournyLaw, Excitation, Motor,
    MudMotor, RateLaw, RegenerativeLaw, RockLaw, SteadyCut, TableFault, TableLaw, TablePoint,
    TableUse,
};
pub use energy::EnergyBalance;
pub use frame::{Channel, FRAME, Frame};
pub use indicators::{Indicators, StickSlip, TorqueUse, Whirl};
pub use lift::{LIFT_TOLERANCE, LiftError, MOST_LIFT_RUNS, TunedLift, tune_lift};
pub use outcome::{DynamicOutcome, Numerics, Statistic};
pub use precision::Simulation;
pub use schedule::{HoistSetPoint, Schedule, ScheduleFault, ScheduleStep};
pub use settings::{
    Autodriller, CentredStart, ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, HoistLine,
    Precision, RodDamping, SpeedController, Start, StartTension, TopDriveSettings, UntilSteady,
};
pub use setup::{Effort, SetupError};
pub use signal::{NodeSignal, Probe, Probed};
pub use simulation::{Checkpoint, Diverged, ResumeError};
