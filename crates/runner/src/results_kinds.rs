//! All kinds of results: recognition of them in a folder, and their pages and pictures made again.

use std::{
    fs,
    path::{Path, PathBuf},
};

use wholestring_report::{Bha, BitTest, Calibration, Modes, Plan, Plot, Reach};
use wholestring_results::{ResultsError, ResultsFolder};
use wholestring_units::UnitSet;

use crate::{
    error::{Error, contained},
    folder_name::file_name,
    page::FILE,
    results_kind::{Overlay, ResultsKind},
    run::pictures::{RUN, overlaid},
    sweep::page::SWEEP,
};

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
    kind_of(folder).map(|kind| kind.noun).or_else(|error| match sweeps(folder).is_empty() {
        true => Err(error),
        false => Ok(STUDY),
    })
}

/// Names of the folders of the sweeps of a study, in order.
fn sweeps(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let sweeps = entries.filter(|entry| (SWEEP.is_in)(&entry.path()));
    let mut names: Vec<String> =
        sweeps.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
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
        let place = folder.display();
        Error::BadInput(match &sweeps(folder)[..] {
            [] => format!("{place} holds no results: neither summary.json nor sweep.csv is there"),
            names => format!(
                "{place} holds a study; name the folder of one of its sweeps, {}: `wholestring \
                 study` with --resume makes the page of the study again",
                names.join(", ")
            ),
        })
    })
}

// The page of any results in a folder.

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

// Pictures of any results in a folder, or of two runs on the same axes.

/// Draws the results in a folder, or two runs on the same axes, in these units; by default in those
/// of the case.
///
/// # Errors
/// Folders whose results cannot be drawn, or not together.
pub fn pictures(folders: &[PathBuf], units: Option<UnitSet>) -> Result<Vec<Plot>, Error> {
    let plots = contained(|| match folders {
        [] => Err(Error::bad_input("no folder is given")),
        [folder] => (kind_of(folder)?.plots)(folder, units),
        _ => together(folders, units),
    })?;
    if plots.is_empty() {
        let place = folders[0].display();
        return Err(Error::BadInput(format!("nothing was solved in {place}")));
    }
    Ok(plots)
}

/// Draws results on the same axes, if they are of one kind that allows it.
fn together(folders: &[PathBuf], units: Option<UnitSet>) -> Result<Vec<Plot>, Error> {
    let kinds = folders.iter().map(|folder| kind_of(folder));
    let kinds = kinds.collect::<Result<Vec<_>, _>>()?;
    if let Some(alone) = kinds.iter().find(|kind| kind.overlay == Overlay::Nothing) {
        return Err(Error::BadInput(format!("{} cannot be overlaid with anything", alone.noun)));
    }
    if let Some(other) = kinds.iter().position(|kind| kind.overlay != kinds[0].overlay) {
        return Err(Error::BadInput(format!(
            "nothing to overlay: {} is {}, {} is {}",
            folders[0].display(),
            kinds[0].noun,
            folders[other].display(),
            kinds[other].noun
        )));
    }
    match kinds[0].overlay {
        Overlay::Varied => Err(Error::BadInput(format!(
            "two {}s cannot be overlaid: vary in one what distinguishes them",
            kinds[0].noun.trim_start_matches("a ")
        ))),
        _ => overlaid(folders, units),
    }
}

/// Default folder of the pictures of these folders: those of two runs do not replace those of the
/// first run.
pub fn pictures_folder(folders: &[PathBuf]) -> PathBuf {
    let name = match folders.get(1).and_then(|second| second.file_name()) {
        Some(second) => format!("plots-{}", file_name(&second.to_string_lossy())),
        None if folders.len() > 1 => "plots-both".to_owned(),
        None => "plots".to_owned(),
    };
    let first = folders.first().map_or(Path::new(""), PathBuf::as_path);
    first.join(name)
}
