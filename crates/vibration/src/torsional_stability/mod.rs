//! Torsional stability: whether the steady rotation of a drilling string is stable, or stick-slip
//! begins.
//!
//! Small motions `e^{st}` about steady rotation: the string is a chain in torsion and one along the
//! hole, with the dynamics' inertia, stiffness and damping; the top drive and the hoist end it
//! above, the law of the bit couples the two below; wall friction and mud act along it with their
//! slopes. Roots of its determinant are counted by the argument principle. Theory:
//! `docs/src/theory/torsional-stability.md`.

mod bit;
mod chain;
mod characteristic;
mod drive;
mod drive_choice;
mod hoist;
mod map;
mod of_case;
mod pressing;
mod roots;
mod settings;
mod wall;

pub use bit::{LinearBit, LinearRock};
pub use chain::LumpedChain;
pub use characteristic::SteadyRotation;
pub use drive::LinearDrive;
pub use drive_choice::TunedDrive;
pub use hoist::LinearHoist;
pub use map::{
    StabilityAtWeight, StabilityLine, StabilityPoint, Threshold, TorsionalStability,
    USUAL_STATIC_OVER_KINETIC,
};
pub use of_case::StabilityOfCase;
pub use pressing::LiesBy;
pub use roots::{Band, Root, Stability};
pub use settings::{HIGHEST_HZ, StabilityError, StabilityRange, StabilitySettings};
