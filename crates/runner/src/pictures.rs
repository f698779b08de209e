//! Pictures of any results in a folder, or of two runs on the same axes.

use std::path::{Path, PathBuf};

use wholestring_report::Plot;
use wholestring_units::UnitSet;

use crate::{
    error::{Error, contained},
    folder_name::file_name,
    results_kind::Overlay,
    results_kinds::kind_of,
    run::pictures::overlaid,
};

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
