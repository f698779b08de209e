//! Verification of the parts of the time loop, driven piece by piece.

mod beams;
pub mod bench;
mod bit;
mod damping;
mod gyroscope;
mod hoist;
mod imbalance;
mod large;
mod mud;
mod order;
mod pendulum;
mod regions;
mod rest;
mod rotor;
mod rough;
mod step_limit;
mod stick_slip;
mod stiction;
mod top_drive;
mod viscous;
mod wall;
mod waves;
