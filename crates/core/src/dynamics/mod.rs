//! The whole string in time: 3D nonlinear rod, wall contact and friction, top drive, hoist and bit.

mod assemble;
mod body;
mod boundary;
mod hook_load;
mod initial_state;
mod kernel;
mod output;
mod settings;
mod simulation;
#[cfg(test)]
mod tests;

pub use crate::outcome::{
    ContactClass, ContactMap, HoleWear, Profile as NodeProfile, Signal, TimeSeries,
};
pub use assemble::{
    SetupError,
    basis::Effort,
    chain::{hoisting, lateral_mass_kg_per_m},
};
pub use boundary::{
    bit::{
        Band, BitExcitation, BitRockStep, BitSettings, BitTable, CustomExcitation, Cutters,
        Excitation, Motor, MudMotor, Shake, SteadyCut, TableFault, TablePoint, TableUse, law::*,
    },
    extension::AnotherExtension,
    friction_coefficient::{CustomFriction, FrictionCoefficient, SlidingContact},
    hole_friction::FrictionFault,
    top_drive::{Gains, Shown, TorsionalString},
    top_drive_controller::{CustomTopDrive, TopDriveController, TopDriveReading},
};
pub use hook_load::{MAX_TUNING_RUNS, TunedHookLoad, TuningError, tune_hook_load};
pub use output::{
    energy::EnergyBalance,
    frame::{Channel, FRAME, Frame},
    indicators::{Indicators, StickSlip, TorqueUse, Whirl},
    outcome::{DeepestContact, DynamicOutcome, Numerics},
    probe::{NodeSignal, Probe, Probed},
    statistic::Statistic,
};
pub use settings::{
    Autodriller, CentredStart, DynamicsSettings, FrictionLaw, HoistControl, HoistLine, Precision,
    RodDamping, SpeedController, Start, StartTension, TopDriveSettings, UntilSteady,
    WEIGHT_TOLERANCE,
    mesh::{MeshSettings, Regions},
    schedule::{HoistSetPoint, Schedule, ScheduleFault, ScheduleStep},
};
pub use simulation::{
    Simulation,
    checkpoint::{Checkpoint, ResumeError},
    diverged::Diverged,
    observer::Observer,
};

#[cfg(feature = "rayon")]
pub use simulation::threads::ThreadsError;

pub use body::levers_kg_m;
pub(crate) use simulation::kernel_speed;

pub use crate::{
    sizing::{Accuracy, ElementLength},
    wall::contact::ContactLaw,
};
