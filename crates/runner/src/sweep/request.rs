//! Request of a sweep.

use std::sync::Arc;

use wholestring_case::{Override, Template, Variation};

use crate::{batch::BatchOptions, keep::Keep};

/// Request to solve a case with all combinations of some values, the last key varying fastest.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case file.
    pub template: &'a Arc<Template>,
    /// Changes in every case.
    pub overrides: &'a [Override],
    /// Varied keys with their values.
    pub variations: &'a [Variation],
    /// Whether the keys are varied together: the n-th case has the n-th value of every key.
    pub together: bool,
    /// Files of each case that are kept. By default its tables if dynamics solve it or CSV is
    /// requested, otherwise its summary.
    pub keep: Option<Keep>,
    /// Options for solving the cases.
    pub batch: BatchOptions,
}
