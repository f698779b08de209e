//! Results folders and their files.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use super::{
    case_file::id_of,
    folder::{Workspace, WorkspaceError},
};

/// Maximum depth of folders within a results folder: study, sweep, case, plots.
const DEPTH: usize = 4;

/// Maximum number of listed files of a results folder.
const FILES: usize = 5000;

/// Output folder of the command line.
const OUT: &str = "out";

/// A results folder.
#[derive(Debug, Clone)]
pub(crate) struct ResultsPlace {
    /// Identifier in requests.
    pub(crate) id: String,
    /// Path within the folder, with forward slashes.
    pub(crate) shown: String,
    /// Path on disk.
    pub(crate) path: PathBuf,
}

/// A file of a results folder.
#[derive(Debug, Clone)]
pub(crate) struct ResultsFile {
    /// Identifier in requests.
    pub(crate) id: String,
    /// Path within the results folder, with forward slashes.
    pub(crate) shown: String,
    /// Path on disk.
    pub(crate) path: PathBuf,
    /// Size, bytes.
    pub(crate) bytes: u64,
}

impl Workspace {
    /// The results folders, by path.
    pub(crate) fn results(&self) -> Vec<ResultsPlace> {
        let places = self.walk().into_iter().filter(|place| place.holds_results);
        let places = places.filter_map(|place| {
            let path = self.inside(&place.path).ok()?;
            Some(ResultsPlace { id: id_of(&place.shown), shown: place.shown, path })
        });
        let mut found: Vec<ResultsPlace> = places.collect();
        found.sort_by(|one, other| one.shown.cmp(&other.shown));
        found
    }

    /// Returns the results folder with an id.
    ///
    /// # Errors
    /// No folder has it.
    pub(crate) fn results_of(&self, id: &str) -> Result<ResultsPlace, WorkspaceError> {
        let found = self.results().into_iter().find(|place| place.id == id);
        found.ok_or(WorkspaceError::Nothing("folder of results"))
    }

    /// Identifier of a results folder in requests, made from its path in the folder.
    pub(crate) fn results_id(shown: &str) -> String {
        id_of(shown)
    }

    /// The path relative to the folder, with forward slashes; none if it is outside.
    pub(crate) fn shown(&self, path: &Path) -> Option<String> {
        let within = path.strip_prefix(self.root()).ok()?;
        let parts = within.iter().map(|part| part.to_string_lossy());
        Some(parts.collect::<Vec<_>>().join("/"))
    }

    /// The files of a results folder, by path, without links and names that begin with a dot.
    pub(crate) fn files_of(&self, place: &ResultsPlace) -> Vec<ResultsFile> {
        let mut found = Vec::new();
        look(&place.path, "", 0, &mut found);
        found.sort_by(|one, other| one.shown.cmp(&other.shown));
        found
    }

    /// Refuses to write results if `out` contains a link that leads out of the folder, because
    /// results would be written through it.
    ///
    /// # Errors
    /// The link.
    pub(crate) fn check_out(&self) -> Result<(), WorkspaceError> {
        let out = self.root().join(OUT);
        self.check_links(&out, 0).map_err(WorkspaceError::system("results cannot go to the folder"))
    }

    fn check_links(&self, path: &Path, depth: usize) -> io::Result<()> {
        let about = match fs::symlink_metadata(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
            about => about?,
        };
        if about.is_symlink() {
            let shown = self.shown(path).unwrap_or_default();
            let wrong =
                |error: io::Error| io::Error::new(error.kind(), format!("{shown}: {error}"));
            self.inside(path).map_err(wrong)?;
        }
        if !about.is_dir() || depth > DEPTH {
            return Ok(());
        }
        fs::read_dir(path)?.try_for_each(|entry| self.check_links(&entry?.path(), depth + 1))
    }
}

fn look(folder: &Path, above: &str, depth: usize, found: &mut Vec<ResultsFile>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let (Ok(name), Ok(about)) = (entry.file_name().into_string(), entry.metadata()) else {
            continue;
        };
        if name.starts_with('.') || found.len() == FILES {
            continue;
        }
        let shown = format!("{above}{name}");
        // The metadata of a directory entry do not follow links.
        if about.is_dir() && depth < DEPTH {
            look(&entry.path(), &format!("{shown}/"), depth + 1, found);
        } else if about.is_file() {
            let (id, path, bytes) = (id_of(&shown), entry.path(), about.len());
            found.push(ResultsFile { id, shown, path, bytes });
        }
    }
}
