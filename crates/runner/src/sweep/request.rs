//! A sweep that is requested.

use wholestring_case::{Override, Template, Variation};

use super::{batch::Batch, checked_points::CheckedPoints, points::points, set::Set};
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
    pub template: &'a Template,
    /// What is changed in every case.
    pub overrides: &'a [Override],
    /// The keys that are varied, with their values.
    pub variations: &'a [Variation],
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
    let options = &request.batch;
    let points = points(request.template, request.overrides, request.variations)?;
    let valid = CheckedPoints::check(points, options, observer, cancellation)?;
    let name = format!("{} sweep", valid.first_name());
    let within_itself = |path: &std::path::Path, _| path.to_owned();
    let claimed = valid.claim("sweep", &name, options, observer, &within_itself)?;
    let keys = request.variations.iter().map(|of| of.key.clone());
    let set = Set {
        prefix: String::new(),
        folder: claimed.folder.clone(),
        keys: keys.collect(),
        keep: request.keep,
        needs: Keep::Summary,
    };
    let mut batch = Batch::new(options, vec![set], valid, observer, cancellation);
    batch.solve_all()?;
    Ok(batch.outcome(claimed.folder.path()))
}
