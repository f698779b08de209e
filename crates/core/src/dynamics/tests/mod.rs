//! Verification of what the time loop is made of, driven piece by piece.

mod beams;
mod bench;
mod bit;
mod hoist;
mod step_limit;
mod waves;
