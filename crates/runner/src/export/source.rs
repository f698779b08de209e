//! Source of an export.

use std::path::{Path, PathBuf};

use serde_json::Value as Json;
use wholestring_results::read_any_summary;

use super::format::What;
use crate::{error::Error, results_kinds::kind_of};

/// Source of an export: its name, and the settings with all defaults.
pub(super) struct Source {
    pub(super) name: String,
    pub(super) settings: Json,
    /// Folder of results; `None` for a case file.
    pub(super) folder: Option<PathBuf>,
}

/// A folder of results.
pub(super) fn of_folder(folder: &Path, what: What) -> Result<Source, Error> {
    let kind = kind_of(folder)?;
    let path = folder.join("summary.json");
    let folder = Some(folder.to_owned());
    if !path.is_file() {
        if what == What::Results {
            return Ok(Source { name: "Sweep".to_owned(), settings: Json::Null, folder });
        }
        return Err(Error::bad_input(format!(
            "{} holds {}, whose cases may differ: name the folder of one of them, or the case file",
            path.parent().unwrap_or(&path).display(),
            kind.noun
        )));
    }
    (kind.check_summary)(&path)?;
    let mut summary = read_any_summary(&path)?;
    let settings = summary.get_mut("settings").map(Json::take).unwrap_or_default();
    let name = summary["case"].as_str().unwrap_or("Case").to_owned();
    Ok(Source { name, settings, folder })
}

/// A case file.
pub(super) fn of_case(file: &Path) -> Result<Source, Error> {
    let case = wholestring_case::load(file, &[])?;
    Ok(Source { name: case.name, settings: case.settings, folder: None })
}
