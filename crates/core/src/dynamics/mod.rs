//! The whole string in time: 3D nonlinear rod, wall contact and friction, top drive, hoist and bit.

mod assemble;
mod body;
mod boundary;
mod initial_state;
mod kernel;
mod lift;
mod output;
mod settings;
mod simulation;
#[cfg(test)]
mod tests;

pub use assemble::basis::{Effort, SetupError};
pub use boundary::bit::{
    Band, BitLaw, BitSettings, BitTable, Cutters, DetournayDefournyLaw, Excitation, Motor,
    MudMotor, RateLaw, RegenerativeLaw, RockLaw, SteadyCut, TableFault, TableLaw, TablePoint,
    TableUse,
};
pub use lift::{LIFT_TOLERANCE, LiftError, MOST_LIFT_RUNS, TunedLift, tune_lift};
pub use output::energy::EnergyBalance;
pub use output::frame::{Channel, Frame};
pub use output::indicators::{Indicators, StickSlip, TorqueUse, Whirl};
pub use output::outcome::{
    ContactClass, ContactMap, DynamicOutcome, HoleWear, NodeProfile, Numerics, Percentiles,
    Statistic, TimeSeries,
};
pub use output::signal::{NodeSignal, Probe, Probed, Signal};
pub use settings::schedule::{HoistSetPoint, Schedule, ScheduleFault, ScheduleStep};
pub use settings::{
    Autodriller, CentredStart, ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, HoistLine,
    Precision, RodDamping, SpeedController, Start, StartTension, TopDriveSettings, UntilSteady,
};
pub use simulation::{
    Simulation,
    checkpoint::{Checkpoint, ResumeError},
    numbers::Diverged,
};
