//! A plan that is requested.

use std::{num::NonZeroUsize, time::Duration};

use wholestring_case::{Case, Override, Template};
use wholestring_units::UnitSet;

use super::overlay::Overlay;
use crate::output::Output;

/// A case whose plan is to be made.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// Its text, to be read again with each sample of what is uncertain in it, and with what a row of
    /// measured weights changes.
    pub template: &'a Template,
    /// What is changed in it.
    pub overrides: &'a [Override],
    /// Units of the page, the pictures and the workbook; the case's by default.
    pub units: Option<UnitSet>,
    /// Where the results go.
    pub output: Output,
    /// Number of parallel jobs; one per core by default.
    pub jobs: Option<NonZeroUsize>,
    /// Wall-clock time between checkpoints; the case's by default.
    pub checkpoint_every: Option<Duration>,
    /// Another program's curves, to be laid over those of the plan.
    pub overlay: Option<Overlay>,
    /// Whether the pictures are painted as PNG too.
    pub png: bool,
}
