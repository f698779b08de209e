//! The page of whatever results a folder holds.

use std::path::{Path, PathBuf};

use wholestring_results::ResultsFolder;
use wholestring_units::UnitSet;

use crate::{
    error::{Error, contained},
    page::FILE,
    results_kinds::kind_of,
};

/// Makes the page of a folder of results again, from its files, and says where it is. It opens with
/// these units, with the case's where none are given.
///
/// # Errors
/// A folder that holds no results, or whose files do not suffice; a page that cannot be written.
pub fn write_report(folder: &Path, units: Option<UnitSet>) -> Result<PathBuf, Error> {
    let kind = kind_of(folder)?;
    let results = ResultsFolder::create(folder)?;
    contained(|| (kind.write_again)(&results, units))?;
    Ok(folder.join(FILE))
}
