//! Names of files that more than one part of a results folder knows.

pub(crate) const CHECKPOINT: &str = "checkpoint.bin";

/// The table against time, without the ending of its file.
pub(crate) const TIME_TABLE: &str = "time";
