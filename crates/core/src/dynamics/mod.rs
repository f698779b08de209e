//! The whole string in time: 3D nonlinear rod, wall contact and friction, top drive, hoist and bit.

mod chain;
mod settings;
mod step;

pub use settings::{
    BitSettings, ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, HoistLine, RodDamping,
    Start,
};
