//! Names of files that more than one part of a results folder knows.

pub(crate) const CHECKPOINT: &str = "checkpoint.bin";
