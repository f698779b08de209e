//! A sweep that is requested.

use std::sync::Arc;

use wholestring_case::{Override, Template, Variation};

use super::in_hand::InHand;
use crate::{
    batch::{BatchOptions, BatchOutcome},
    cancellation::CancellationToken,
    error::Error,
    keep::Keep,
    observer::Observer,
};

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
    /// What is kept of each case. Where nothing is said: its tables where dynamics solve it or they
    /// are requested as CSV, else its summary.
    pub keep: Option<Keep>,
    /// How the cases are solved.
    pub batch: BatchOptions,
}

/// Checks every case, solves them, and writes `sweep.csv` and a page beside the folders of the
/// cases.
///
/// # Errors
/// Cases that are not sound, or a folder that the results cannot go to. What becomes of the cases
/// is identified by the outcome.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<BatchOutcome, Error> {
    InHand::begin(request, observer, cancellation)?.solve(observer, cancellation)
}
