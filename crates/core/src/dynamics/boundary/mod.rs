//! Boundary conditions and loads of the string: hole, mud, hoist, top drive and bit.

pub mod anchor;
pub mod bit;
pub mod executor;
pub mod extension;
pub mod friction_coefficient;
pub mod hoist;
pub mod hole;
pub mod hole_friction;
pub mod mud;
pub mod top_drive;
pub mod top_drive_controller;
pub mod wall_friction;
