//! Copies of results in another folder.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use wholestring_results::{Occupant, ResultsError, digest};

use crate::{
    claim::{Claim, remove_results},
    error::Error,
    observer::Observer,
    output::Output,
    results_kinds::results_kind,
};

/// Copies results from one folder to another and returns the latter: the folder that `output`
/// names, or the command's default. Existing files there are replaced under the same rules as by
/// the command itself.
///
/// # Errors
/// A folder without results, or one that cannot take them.
pub fn copy_results(
    from: &Path,
    output: &Output,
    observer: &dyn Observer,
) -> Result<PathBuf, Error> {
    let files = files(from).map_err(|source| read(from, source))?;
    let occupant = match Occupant::of_folder(from) {
        Some(occupant) => occupant,
        None => guessed(from)?,
    };
    let is_itself = |to: &PathBuf| match (fs::canonicalize(from), fs::canonicalize(to)) {
        (Ok(from), Ok(to)) => from == to,
        _ => false,
    };
    if let Some(to) = output.folder.as_ref().filter(|to| is_itself(to)) {
        return Ok(to.clone());
    }
    let claimed = Claim {
        is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
        ..Claim::new(occupant, output, observer)
    }
    .folder()?;
    let to = claimed.folder.path();
    // Files of earlier results that these do not have are removed.
    remove_results(to)?;
    for file in files {
        let path = to.join(&file);
        let copied = path.parent().map_or(Ok(()), fs::create_dir_all);
        // Written under another name until complete.
        let partial = partial(&path);
        let copied = copied.and_then(|()| fs::copy(from.join(&file), &partial));
        let copied = copied.and_then(|_| fs::rename(&partial, &path));
        copied.map_err(|source| {
            let _ = fs::remove_file(&partial);
            ResultsError::Write { path, source }
        })?;
    }
    Ok(to.to_owned())
}

fn partial(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".partial");
    path.with_file_name(name)
}

/// Owner of results that do not record it.
fn guessed(from: &Path) -> Result<Occupant, Error> {
    let kind = results_kind(from)?.to_owned();
    let name = from.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let contents = ["summary.json", "sweep.csv"].map(|file| fs::read(from.join(file)).ok());
    Ok(Occupant { kind, name, identity: digest(&contents) })
}

fn read(path: &Path, source: io::Error) -> ResultsError {
    ResultsError::Read { path: path.to_owned(), source }
}

/// All files in a folder and its subfolders, except those with a leading dot in their names, with
/// paths relative to the folder; links are excluded.
fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut all = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(within) = folders.pop() {
        for entry in fs::read_dir(folder.join(&within))? {
            let entry = entry?;
            let (name, kind) = (entry.file_name(), entry.file_type()?);
            let path = within.join(&name);
            if name.to_string_lossy().starts_with('.') {
            } else if kind.is_dir() {
                folders.push(path);
            } else if kind.is_file() {
                all.push(path);
            }
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Existing, Silent};

    /// Copies protect existing results in the same way as commands.
    #[test]
    fn a_copy_protects_other_results() {
        let place = tempfile::tempdir().unwrap();
        let at = |name: &str| place.path().join(name);
        let put = |folder: &str, identity: &str| {
            fs::create_dir_all(at(folder).join("plots")).unwrap();
            let owner = format!(r#"{{"kind":"plan","name":"a plan","identity":"{identity}"}}"#);
            fs::write(at(folder).join(".wholestring"), owner).unwrap();
            fs::write(at(folder).join("summary.json"), identity).unwrap();
            fs::write(at(folder).join("plots/torque.svg"), identity).unwrap();
        };
        put("one", "1");
        put("other", "2");
        let copy = |from: &str, to: &str, existing: Existing| {
            let output = Output { folder: Some(at(to)), existing, ..Output::default() };
            copy_results(&at(from), &output, &Silent)
        };
        copy("one", "here", Existing::Protect).unwrap();
        copy("one", "here", Existing::Protect).unwrap();
        let refused = copy("other", "here", Existing::Protect).unwrap_err();
        assert!(matches!(refused, Error::Folder(_)), "{refused}");
        let text = |name: &str| fs::read_to_string(at("here").join(name)).unwrap();
        assert_eq!([text("summary.json"), text("plots/torque.svg")], ["1", "1"]);
        copy("other", "here", Existing::Overwrite).unwrap();
        assert_eq!([text("summary.json"), text("plots/torque.svg")], ["2", "2"]);
        assert_eq!(Occupant::of_folder(&at("here")).unwrap().identity, "2");
        // A copy onto itself loses nothing.
        copy("one", "one", Existing::Overwrite).unwrap();
        assert!(at("one").join("summary.json").is_file());
    }
}
