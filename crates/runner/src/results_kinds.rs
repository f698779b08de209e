//! All kinds of results, and which of them a folder holds.

use std::{fs, path::Path};

use wholestring_report::{Bha, BitTest, Calibration, Modes, Plan, Reach};

use crate::{error::Error, results_kind::ResultsKind, run::pictures::RUN, sweep::page::SWEEP};

/// Every kind; what a folder holds is the first that is in it.
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

/// What a folder of a study holds.
const STUDY: &str = "a study";

/// What the folder holds the results of: `a run`, `a plan`, `a study`, ...
///
/// # Errors
/// It holds none.
pub fn results_kind(folder: &Path) -> Result<&'static str, Error> {
    kind_of(folder).map(|kind| kind.noun).or_else(|error| {
        let mut entries = fs::read_dir(folder).into_iter().flatten().flatten();
        // A study has the sweeps that it is made of.
        let is_study = entries.any(|entry| (SWEEP.is_in)(&entry.path()));
        if is_study { Ok(STUDY) } else { Err(error) }
    })
}

/// What the folder holds the results of.
///
/// # Errors
/// It holds none that pages and pictures are made of.
pub(crate) fn kind_of(folder: &Path) -> Result<&'static ResultsKind, Error> {
    KINDS.iter().find(|kind| (kind.is_in)(folder)).ok_or_else(|| {
        Error::BadInput(format!(
            "{} holds no results: neither summary.json nor sweep.csv is there",
            folder.display()
        ))
    })
}
