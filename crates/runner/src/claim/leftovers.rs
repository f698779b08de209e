//! Results that an earlier command left in a folder.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use wholestring_results::{Occupant, ResultsError, ResultsFolder, Summary, TABLES};

use crate::{page::FILE, results_kinds::KINDS, shard::SHARES};

/// Files that identify a folder of results of any kind.
const KNOWN: [&str; 4] = ["summary.json", "checkpoint.bin", "sweep.csv", "point.json"];

/// Other files that every command may write in addition.
const OTHERS: [&str; 2] = [FILE, "checkpoint.bin.partial"];

/// Subfolders that commands create in the folder of their results, and the extensions of the files
/// in them.
const MADE: [&str; 6] = ["plots", "figures", "tables", "frames.parts", "time.parts", SHARES];
const PUT_THERE: [&str; 7] = [".svg", ".png", ".csv", ".md", ".parquet", ".json", ".lock"];

/// Whether a command wrote a file of that name into the folder of its results.
fn is_written(name: &str) -> bool {
    let table = name.strip_suffix(".parquet").or_else(|| name.strip_suffix(".csv"));
    KNOWN.contains(&name)
        || OTHERS.contains(&name)
        || table.is_some_and(|table| TABLES.iter().any(|(known, _)| *known == table))
        || KINDS.iter().any(|kind| kind.has_file(name))
}

/// Folders whose contents a command replaces whole.
const PARTS: [&str; 2] = ["frames.parts", "time.parts"];

/// Files and folders of a folder without a record that results would replace: somebody else's, such
/// as a log of the rig that is called `time.csv`.
pub(super) fn foreign(path: &Path) -> Result<Vec<String>, ResultsError> {
    let is_replaced = |name: &str, is_folder: bool| match is_folder {
        true => PARTS.contains(&name),
        false => is_written(name),
    };
    let entries = entries(path)?.into_iter();
    let mut names: Vec<String> = entries
        .filter(|(name, _, is_folder)| is_replaced(name, *is_folder))
        .map(|(name, ..)| name)
        .collect();
    names.sort();
    Ok(names)
}

fn holds_results(path: &Path) -> bool {
    KNOWN.iter().any(|known| path.join(known).is_file())
}

/// Returns the occupant of the results in the folder: `None` if there are no results, `Some(None)`
/// if their case is unknown.
///
/// The record in the folder takes precedence over the result files, because files of an earlier
/// version do not identify their case.
pub(super) fn occupant(
    folder: &ResultsFolder,
    owner: Option<&Occupant>,
) -> Option<Option<Occupant>> {
    if let Some(owner) = owner {
        return Some(Some(owner.clone()));
    }
    let path = folder.path();
    if !holds_results(path) {
        return None;
    }
    let summary = Summary::read(&path.join("summary.json")).ok();
    let run = summary.and_then(|summary| {
        Some(Occupant { kind: "run".into(), name: summary.case, identity: summary.identity? })
    });
    Some(run)
}

/// Removes results from a folder: those of a run, and the folders of the cases of a sweep or a
/// study. Other files are kept.
pub(crate) fn remove(path: &Path) -> Result<(), ResultsError> {
    remove_within(path, 0)
}

/// Depth of study, sweep, case and plots.
const DEEPEST: usize = 4;

fn remove_within(path: &Path, depth: usize) -> Result<(), ResultsError> {
    let made = path.file_name().and_then(|name| name.to_str());
    let made = depth > 0 && made.is_some_and(|name| MADE.contains(&name));
    for (name, path, is_folder) in entries(path)? {
        if is_folder {
            let known = holds_results(&path) || MADE.contains(&&*name);
            // A sweep of a study that was killed early contains only the folders of its cases.
            let known = known || entries(&path)?.iter().any(|(_, path, _)| holds_results(path));
            if known && depth < DEEPEST {
                remove_within(&path, depth + 1)?;
                // The folder is kept if it contains other files.
                let _ = fs::remove_dir(&path);
            }
        } else if is_written(&name) || made && PUT_THERE.iter().any(|end| name.ends_with(end)) {
            fs::remove_file(&path).map_err(|source| ResultsError::Write { path, source })?;
        }
    }
    Ok(())
}

/// Names, paths and whether they are folders; links do not count as folders.
fn entries(path: &Path) -> Result<Vec<(String, PathBuf, bool)>, ResultsError> {
    let read = || -> io::Result<Vec<_>> {
        let all = fs::read_dir(path)?.map(|entry| {
            let entry = entry?;
            let name = entry.file_name().to_string_lossy().into_owned();
            Ok((name, entry.path(), entry.file_type()?.is_dir()))
        });
        all.collect()
    };
    read().map_err(|source| ResultsError::Read { path: path.to_owned(), source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_result_stays() {
        let place = tempfile::tempdir().expect("a folder");
        let put = |name: &str| {
            let path = place.path().join(name);
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(path, "").expect("a file");
        };
        let results = [
            "summary.json",
            "nodes.parquet",
            "time.csv",
            "plots/tracks.svg",
            "plots/tracks.png",
            "frames.parts/000001.parquet",
            "friction=0.1/summary.json",
            "friction=0.1/nodes.parquet",
            "sweep/friction=0.1/checkpoint.bin",
            ".shares/1-of-2.json",
            ".shares/1-of-2.lock",
        ];
        let others = [
            "survey.csv",
            "my-well.toml",
            "notes/summary.txt",
            "plots/mine.xcf",
            "friction=0.1/notes.txt",
        ];
        results.iter().chain(&others).for_each(|name| put(name));
        remove(place.path()).expect("removed");
        let is_there = |name: &&str| place.path().join(name).exists();
        assert!(!results.iter().any(is_there));
        assert!(others.iter().all(is_there));
        assert!(!is_there(&"sweep") && !is_there(&"frames.parts"));
    }
}
