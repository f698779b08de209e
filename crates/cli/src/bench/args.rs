//! Arguments of `wholestring bench`.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, ValueEnum};
use wholestring_case::Override;

#[derive(Debug, Args)]
pub(crate) struct BenchArgs {
    /// Parts to measure [default: all but the sweep]
    #[arg(value_enum, value_name = "PART")]
    pub(crate) parts: Vec<BenchPart>,

    /// Set a key of the case that is measured, NP13-X1042. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,

    /// Measurements of which the median is shown
    #[arg(long, value_name = "N", default_value = "10")]
    pub(crate) repeat: NonZeroUsize,

    /// Write the numbers to this file too
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BenchPart {
    /// The inner loop with each instruction set, against the processor's peak
    Kernel,
    /// All that a run does, with each instruction set
    Run,
    /// Memory of a run, on Linux
    Memory,
    /// Cost of each mechanism when it is switched on
    Mechanisms,
    /// The solid rock under a bit, with each instruction set
    Rock,
    /// 60 cases for each friction law on all cores: minutes
    Sweep,
}
