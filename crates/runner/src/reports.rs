//! The page of whatever results a folder holds.

use std::path::{Path, PathBuf};

use wholestring_results::ResultsFolder;
use wholestring_units::UnitSet;

use crate::{
    bha::page as bha,
    bit_test::page as bit_test,
    calibrate::page as calibrate,
    error::Error,
    modes::page as modes,
    page::{FILE, lacking, page},
    plan::page as plan,
    reach::page as reach,
    results_kind::ResultsKind,
    sweep::page as sweep,
};

/// Makes the page of a folder of results again, from its files, and says where it is. It opens with these units, with the case's where none are given.
///
/// # Errors
/// A folder that holds no results, or whose files do not suffice; a page that cannot be written.
pub fn write_report(folder: &Path, units: Option<UnitSet>) -> Result<PathBuf, Error> {
    // Whatever the folder holds is the input here.
    let bad = |error: &dyn std::fmt::Display| Error::BadInput(error.to_string());
    let results = || ResultsFolder::create(folder);
    match ResultsKind::of(folder) {
        Some(ResultsKind::BitTest) => {
            let test = bit_test::gather(folder, units).map_err(|error| bad(&error))?;
            bit_test::write(&results()?, &test)?;
        }
        Some(ResultsKind::Bha) => {
            let found = bha::gather(folder, units).map_err(|error| bad(&error))?;
            bha::write(&results()?, &found)?;
        }
        Some(ResultsKind::Modes) => {
            let found = modes::gather(folder, units).map_err(|error| bad(&error))?;
            modes::write(&results()?, &found, false)?;
        }
        Some(ResultsKind::Plan) => plan::write_again(&results()?, units)?,
        Some(ResultsKind::Calibration) => {
            let found = calibrate::gather(folder, units).map_err(|error| bad(&error))?;
            calibrate::write(&results()?, &found, false)?;
        }
        Some(ResultsKind::Reach) => {
            let found = reach::gather(folder, units).map_err(|error| bad(&error))?;
            reach::write(&results()?, &found, false)?;
        }
        Some(ResultsKind::Run) => {
            if let Some(lacking) = lacking(folder).map_err(|error| bad(&error))? {
                return Err(Error::BadInput(lacking));
            }
            let page = page(folder, units).map_err(|error| bad(&error))?;
            results()?.write_file(FILE, page.as_bytes())?;
        }
        Some(ResultsKind::Sweep) => {
            sweep::write(&results()?, units).map_err(|error| bad(&error))?;
        }
        None => return Err(ResultsKind::none(folder)),
    }
    Ok(folder.join(FILE))
}
