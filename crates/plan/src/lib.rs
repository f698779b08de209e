//! Drilling engineers' plans: the same string at many depths and frictions, the limits of its
//! parts, the reach of the well, and calibrated friction.
//!
//! All results are computed from the engine's models ([`wholestring`]), in SI, angles in radians;
//! nothing reads files, prints or starts threads. A [`Setup`] gives the model at any depth of the
//! bit.
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod broomstick;
pub mod calibration;
mod campaign;
pub mod dynamic;
pub mod fatigue;
pub mod hydraulics;
pub mod reach;
mod setup;
mod stage;
pub mod uncertainty;
pub mod wear;

pub use broomstick::{
    Broomstick, BroomstickPoint, BroomstickTask, BucklingWeight, ExpectedLoads, Frictions,
    KindFriction, LevelFriction, PointAnswer, Statics, StringStation, bit_depths_m,
};
pub use campaign::{Campaign, CampaignPart, CampaignSettings, Share};
pub use setup::{PlanError, Setup, WallFriction};
pub use stage::{Stage, lengths_m};
pub use wholestring::well::FrictionLevel;
pub use wholestring_judge::root;
