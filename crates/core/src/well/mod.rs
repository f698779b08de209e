//! The well: the path of the hole's axis and the hole around it.

pub mod casing;
mod constructors;
mod curve;
mod doubtful_turn;
mod hole;
mod kick_off;
mod path;
mod roughness;
mod station;
mod tortuosity;
mod vertical;

pub use doubtful_turn::{
    DoubtfulTurn, USUAL_DOGLEG_RAD_PER_M, doubtful_turns, endured_dogleg_rad_per_m,
};
pub use hole::{
    CasingPipe, Friction, FrictionLevel, Hole, HoleError, HoleKind, HoleSection, NARROWEST_BAND,
};
pub(crate) use path::Heading;
pub use path::{Path, PathError, PathPoint, TieIn};
pub use roughness::{Relief, ReliefPoint, Roughness};
pub use station::{Interpolation, Station};
pub use tortuosity::{Tortuosity, TortuosityKind};

use serde::Serialize;

/// A well: where the hole runs and how wide it is and how it rubs.
#[derive(Debug, Clone, Serialize)]
pub struct Well {
    /// Axis of the hole.
    pub path: Path,
    /// Sections of the hole by measured depth.
    pub hole: Hole,
}
