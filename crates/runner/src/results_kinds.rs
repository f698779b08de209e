//! All kinds of results, and recognition of them in a folder.

use std::{fs, path::Path};

use wholestring_report::{Bha, BitTest, Calibration, Modes, Plan, Reach};
use wholestring_results::{
    BhaSummary, BitTestSummary, CalibrationSummary, ModesSummary, PlanSummary, ReachSummary,
    ResultsError, Summary,
};

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

/// Reads the summary of results of a kind for its errors alone: those of its layout and version.
///
/// # Errors
/// A summary that cannot be read.
pub fn check_summary(noun: &str, summary: &Path) -> Result<(), ResultsError> {
    match noun {
        "a run" => Summary::read(summary).map(drop),
        "a plan" => PlanSummary::read(summary).map(drop),
        "a reach" => ReachSummary::read(summary).map(drop),
        "a calibration" => CalibrationSummary::read(summary).map(drop),
        "modes" => ModesSummary::read(summary).map(drop),
        "a static BHA analysis" => BhaSummary::read(summary).map(drop),
        "a bit test" => BitTestSummary::read(summary).map(drop),
        _ => Ok(()),
    }
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
