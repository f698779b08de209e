//! What is recorded of a run, and what is made of it.

pub mod carry;
pub mod drift;
pub mod energy;
pub mod frame;
pub mod indicators;
pub mod outcome;
pub mod record;
pub mod signal;
pub mod summary;
pub mod wear;
