//! Names of files that several parts of a results folder use.

pub(crate) const CHECKPOINT: &str = "checkpoint.bin";

/// The table against time, without the ending of its file.
pub(crate) const TIME_TABLE: &str = "time";
