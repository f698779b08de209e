//! Verification of what the time loop is made of, driven piece by piece.

mod beams;
mod bench;
mod bit;
mod gyroscope;
mod hoist;
mod imbalance;
mod large;
mod mud;
mod rest;
mod rough;
mod step_limit;
mod stick_slip;
mod top_drive;
mod viscous;
mod wall;
mod waves;
