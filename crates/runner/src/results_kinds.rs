//! All kinds of results, and recognition of them in a folder.

use std::{fs, path::Path};

use wholestring_report::{Bha, BitTest, Calibration, Modes, Plan, Reach};
use wholestring_results::ResultsError;

use crate::{error::Error, results_kind::ResultsKind, run::pictures::RUN, sweep::page::SWEEP};

/// Every kind; the first that matches a folder applies.
pub(crate) static KINDS: [ResultsKind; 8] = [
    ResultsKind::of::<BitTest>(),
    ResultsKind::of::<Bha>(),
    ResultsKind::of::<Modes>(),
    ResultsKind::of::<Plan>(),
    ResultsKind::of::<Calibration>(),
    ResultsKind::of::<Reach>(),
    RUN,
    SWEEP,
];

/// Kind of a folder with a study.
const STUDY: &str = "a study";

/// Kind of results in the folder: `a run`, `a plan`, `a study`, ...
///
/// # Errors
/// It contains none.
pub fn results_kind(folder: &Path) -> Result<&'static str, Error> {
    kind_of(folder).map(|kind| kind.noun).or_else(|error| {
        let mut entries = fs::read_dir(folder).into_iter().flatten().flatten();
        // A study contains the folders of its sweeps.
        let is_study = entries.any(|entry| (SWEEP.is_in)(&entry.path()));
        if is_study { Ok(STUDY) } else { Err(error) }
    })
}

/// Reads the summary of the results in a folder for its errors alone: those of its layout and
/// version.
///
/// # Errors
/// A summary that cannot be read.
pub fn check_summary(folder: &Path) -> Result<(), ResultsError> {
    let kind = KINDS.iter().find(|kind| (kind.is_in)(folder));
    kind.map_or(Ok(()), |kind| (kind.check_summary)(&folder.join("summary.json")))
}

/// Kind of results in the folder.
///
/// # Errors
/// It contains none with pages and pictures.
pub(crate) fn kind_of(folder: &Path) -> Result<&'static ResultsKind, Error> {
    KINDS.iter().find(|kind| (kind.is_in)(folder)).ok_or_else(|| {
        Error::BadInput(format!(
            "{} holds no results: neither summary.json nor sweep.csv is there",
            folder.display()
        ))
    })
}
