//! Records of a run and the results computed from them.

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
pub mod wear;
