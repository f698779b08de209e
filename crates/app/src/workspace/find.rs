//! Which files of the folder are cases.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::{
    case_file::{CaseFile, id_of, modified},
    folder::Workspace,
};

/// Folders below the folder that are searched.
const DEPTH: usize = 4;

/// Files that are looked at.
const FILES: usize = 2000;

/// A case file is no longer, bytes: the reader refuses more.
const LARGEST: u64 = 8 << 20;

/// Folders that hold what programs make.
const SKIPPED: [&str; 2] = ["target", "node_modules"];

/// What lies in every folder of results.
const RESULTS: &str = "summary.json";

impl Workspace {
    /// The case files, by their places.
    pub(crate) fn cases(&self) -> Vec<CaseFile> {
        let mut found = Vec::new();
        let mut left = FILES;
        self.search(self.root(), "", 0, &mut left, &mut found);
        found.sort_by(|one, other| one.shown.cmp(&other.shown));
        found
    }

    /// Looks through one folder. Links to folders are not followed: what they lead to lies elsewhere
    /// in the folder, or outside.
    fn search(
        &self,
        folder: &Path,
        shown: &str,
        depth: usize,
        left: &mut usize,
        found: &mut Vec<CaseFile>,
    ) {
        // A folder that may not be read holds nothing for us.
        let Ok(entries) = fs::read_dir(folder) else { return };
        let mut folders: Vec<(String, PathBuf)> = Vec::new();
        for entry in entries.flatten() {
            let (Ok(name), Ok(kind)) = (entry.file_name().into_string(), entry.file_type()) else {
                continue;
            };
            if name.starts_with('.') {
                continue;
            }
            let shown = format!("{shown}{name}");
            if kind.is_dir() {
                folders.push((shown, entry.path()));
                continue;
            }
            if !name.to_ascii_lowercase().ends_with(".toml") {
                continue;
            }
            if *left == 0 {
                return;
            }
            *left -= 1;
            found.extend(self.case_at(shown, &entry.path()));
        }
        if depth == DEPTH {
            return;
        }
        folders.sort();
        for (shown, path) in folders {
            let name = shown.rsplit('/').next().unwrap_or(&shown);
            if !SKIPPED.contains(&name) && !path.join(RESULTS).exists() {
                self.search(&path, &format!("{shown}/"), depth + 1, left, found);
            }
        }
    }

    /// The file as a case, if it is one that lies in the folder.
    fn case_at(&self, shown: String, path: &Path) -> Option<CaseFile> {
        let path = self.inside(path).ok()?;
        let about = fs::metadata(&path).ok().filter(|about| about.is_file())?;
        if about.len() > LARGEST {
            return None;
        }
        let text = String::from_utf8_lossy(&fs::read(&path).ok()?).into_owned();
        let id = id_of(&shown);
        has_case(&text).then(|| CaseFile { id, shown, path, modified: modified(&about) })
    }
}

/// Whether a text has a well or a string; that it is TOML is not asked, for a case that is being
/// written may be broken.
fn has_case(text: &str) -> bool {
    let headings = text.lines().map(str::trim_start).filter_map(|line| line.strip_prefix('['));
    let mut names = headings.map(|line| line.trim_start_matches('[').trim_start());
    names.any(|name| {
        let end = name.find([']', '.', ' ', '\t']).unwrap_or(name.len());
        matches!(&name[..end], "well" | "string")
    })
}

#[cfg(test)]
mod tests {
    use super::has_case;

    #[test]
    fn a_case_has_a_well_or_a_string() {
        assert!(has_case("name = \"a\"\n[well]\nsurvey = \"s.csv\"\n"));
        assert!(has_case("  [[string]]\ncomponent = \"bit\n"));
        assert!(has_case("[ well.hole ]\n"));
        assert!(has_case("[[ well.hole ]]\n"));
        assert!(!has_case("[package]\nname = \"well\"\n[strings]\n[wells.a]\n"));
        assert!(!has_case("# [well]\n"));
        assert!(!has_case(""));
    }
}
