//! The page of any results in a folder.

use std::path::{Path, PathBuf};

use wholestring_results::ResultsFolder;
use wholestring_units::UnitSet;

use crate::{
    error::{Error, contained},
    page::FILE,
    results_kinds::kind_of,
};

/// Rewrites the page of a folder of results from its files, and returns its path. It opens in these
/// units, by default in those of the case.
///
/// # Errors
/// A folder without results or without the required files, or a page that cannot be written.
pub fn write_report(folder: &Path, units: Option<UnitSet>) -> Result<PathBuf, Error> {
    let kind = kind_of(folder)?;
    let results = ResultsFolder::create(folder)?;
    contained(|| (kind.write_again)(&results, units))?;
    Ok(folder.join(FILE))
}
