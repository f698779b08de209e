//! A sweep that is requested.

use std::sync::Arc;

use wholestring_case::{Override, Template, Variation};

use crate::{batch::BatchOptions, keep::Keep};

/// A case that is to be solved with all combinations of some values, the last key varying fastest.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case file.
    pub template: &'a Arc<Template>,
    /// What is changed in every case.
    pub overrides: &'a [Override],
    /// The keys that are varied, with their values.
    pub variations: &'a [Variation],
    /// Whether the keys are varied together instead: the first value of each, the second of each,
    /// and so on.
    pub together: bool,
    /// What is kept of each case. By default: its tables where dynamics solve it or they
    /// are requested as CSV, else its summary.
    pub keep: Option<Keep>,
    /// How the cases are solved.
    pub batch: BatchOptions,
}
