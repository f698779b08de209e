//! Detection of the case files in the folder.

use std::{fs, path::Path};

use super::{
    case_file::{CaseFile, id_of, modified},
    folder::Workspace,
};

/// Maximum number of files examined.
const FILES: usize = 2000;

/// Maximum size of a case file, bytes: the reader refuses larger ones.
const LARGEST: u64 = 8 << 20;

impl Workspace {
    /// The case files, by path.
    pub(crate) fn cases(&self) -> Vec<CaseFile> {
        let files = self.walk().into_iter();
        let files = files.filter(|place| !place.holds_results && is_toml(&place.shown));
        let cases = files.take(FILES).filter_map(|place| self.case_at(place.shown, &place.path));
        let mut found: Vec<CaseFile> = cases.collect();
        found.sort_by(|one, other| one.shown.cmp(&other.shown));
        found
    }

    /// The file as a case, if it is one inside the folder.
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

/// Whether a file is TOML by its name.
pub(super) fn is_toml(name: &str) -> bool {
    name.to_ascii_lowercase().ends_with(".toml")
}

/// Whether a text has a well or a string. It need not be valid TOML, because a case that is being
/// edited may be invalid.
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
