//! Source of an export, and its time as XML writes it.

use std::{
    path::{Path, PathBuf},
    time::{SystemTime, UNIX_EPOCH},
};

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

// Times as XML writes them.

/// A time as XML writes it, to the second.
pub(super) fn timestamp(time: SystemTime) -> String {
    let seconds = time.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (days, of_day) = (seconds / 86_400, seconds % 86_400);
    // Days since 1 March of the year 0: the leap day then is the last of every fourth year, except
    // in three of four centuries.
    let shifted = days + 719_468;
    let (era, of_era) = (shifted / 146_097, shifted % 146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let from_march = (5 * of_year + 2) / 153;
    let day = of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
    let year = year + era * 400 + u64::from(month <= 2);
    format!(
        "{year:04}-{month:02}-{day:02}T{:02}:{:02}:{:02}Z",
        of_day / 3600,
        of_day / 60 % 60,
        of_day % 60
    )
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn times_are_written_as_xml_writes_them() {
        for (seconds, expected) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_164_799, "2024-02-28T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(timestamp(UNIX_EPOCH + Duration::from_secs(seconds)), expected);
        }
    }
}
