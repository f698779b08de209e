//! Request of a plan.

use std::{num::NonZeroUsize, time::Duration};

use wholestring_case::{Case, Override, Template};
use wholestring_units::UnitSet;

use super::overlay::Overlay;
use crate::output::Output;

/// Request to make the plan of a case.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// Text of the case, which is read again with each sample of its uncertain inputs and with the
    /// changes of a row of measured weights.
    pub template: &'a Template,
    /// Changes of the case.
    pub overrides: &'a [Override],
    /// Units of the page, the pictures and the workbook; by default those of the case.
    pub units: Option<UnitSet>,
    /// Destination of the results.
    pub output: Output,
    /// Number of parallel jobs; one per core by default.
    pub jobs: Option<NonZeroUsize>,
    /// Wall-clock time between checkpoints; by default that of the case.
    pub checkpoint_every: Option<Duration>,
    /// Curves of another program to overlay on those of the plan.
    pub overlay: Option<Overlay>,
    /// Whether to also write PNG images.
    pub png: bool,
}
