//! What is recorded of a run, and what is made of it.

pub mod drift;
pub mod energy;
pub mod frame;
pub mod indicators;
pub mod outcome;
pub mod probe;
pub mod record;
pub mod scene;
pub mod statistic;
pub mod summary;
pub mod varying;
pub mod wear;
