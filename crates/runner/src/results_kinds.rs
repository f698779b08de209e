//! All kinds of results, and which of them a folder holds.

use std::path::Path;

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
