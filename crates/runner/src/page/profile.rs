//! The picture of all tracks of a run.

use wholestring_report::{Report, profile};
use wholestring_results::{ResultsError, ResultsFolder};

/// Name of the picture of all tracks.
pub(crate) const PROFILE: &str = "profile.svg";

/// Draws all tracks of a run; nothing if it has none.
pub(crate) fn write_profile(folder: &ResultsFolder, report: &Report) -> Result<(), ResultsError> {
    match profile(report, &report.units) {
        Some(figure) => folder.write_file(PROFILE, figure.drawing().svg().as_bytes()),
        None => folder.remove(PROFILE),
    }
}
