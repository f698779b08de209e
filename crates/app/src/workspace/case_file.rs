//! A case file of the folder.

use std::{
    borrow::Cow,
    fs, io,
    path::{Path, PathBuf},
    thread,
    time::{Duration, SystemTime},
};

use super::{
    folder::{Workspace, WorkspaceError},
    own::{self, fingerprint},
};

/// A case file of the folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CaseFile {
    /// Identifier in requests, made from its path in the folder and unchanged while the path is.
    pub(crate) id: String,
    /// Path within the folder, with forward slashes, for display.
    pub(crate) shown: String,
    /// Path on disk.
    pub(crate) path: PathBuf,
    /// Time of its last change.
    pub(crate) modified: SystemTime,
}

/// Contents of a case file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CaseText {
    /// Its text, without a byte order mark.
    pub(crate) text: String,
    /// Fingerprint of the contents at that time.
    pub(crate) revision: String,
}

/// A file to create.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NewFile<'a> {
    /// Its name, without a path.
    pub(crate) name: &'a str,
    /// Its contents.
    pub(crate) text: &'a str,
}

impl CaseFile {
    /// Reads its contents.
    ///
    /// # Errors
    /// Errors of the system, and contents that are not text.
    pub(crate) fn read(&self) -> Result<CaseText, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be read");
        let bytes = wholestring_case::read_file(&self.path).map_err(&failed)?;
        let revision = fingerprint(&bytes);
        let not_text = |_| failed(io::Error::other("it is not a text in UTF-8"));
        let text = String::from_utf8(bytes).map_err(not_text)?;
        let text = text.strip_prefix('\u{feff}').map_or_else(|| text.clone(), str::to_owned);
        Ok(CaseText { text, revision })
    }
}

/// Pauses before a file is read: one that another program is writing is empty for a moment, and no
/// case.
const PAUSES: [Duration; 3] =
    [Duration::ZERO, Duration::from_millis(20), Duration::from_millis(80)];

impl Workspace {
    /// Returns the case with an id.
    ///
    /// # Errors
    /// No case of the folder has it.
    pub(crate) fn case(&self, id: &str) -> Result<CaseFile, WorkspaceError> {
        for pause in PAUSES {
            thread::sleep(pause);
            if let Some(found) = self.cases().into_iter().find(|case| case.id == id) {
                return Ok(found);
            }
            let is_its = |shown: &str| is_toml(shown) && id_of(shown) == id;
            if !self.walk().iter().any(|place| is_its(&place.shown)) {
                break;
            }
        }
        Err(WorkspaceError::Nothing("case"))
    }

    /// Replaces the text of a case that is still at `revision`, and returns the new revision. Its
    /// draft is removed.
    ///
    /// # Errors
    /// The file has changed since, and errors of the system.
    pub(crate) fn save(
        &self,
        case: &CaseFile,
        text: &str,
        revision: &str,
    ) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be saved");
        let _alone = self.writing();
        let now = fs::read(&case.path).map_err(&failed)?;
        if fingerprint(&now) != revision {
            return Err(WorkspaceError::Changed);
        }
        own::replace_file(&case.path, text.as_bytes()).map_err(&failed)?;
        self.remove_draft(case)?;
        Ok(fingerprint(text.as_bytes()))
    }

    /// Creates a case file and the files that it names, all or nothing.
    ///
    /// # Errors
    /// Names that no file may have, an existing file with other contents, and errors of the system.
    pub(crate) fn create(
        &self,
        case: NewFile<'_>,
        beside: &[NewFile<'_>],
    ) -> Result<String, WorkspaceError> {
        check_case_name(case.name)?;
        beside.iter().try_for_each(|file| check_name(file.name))?;
        let _alone = self.writing();
        let mut made = Vec::new();
        let all = beside.iter().map(|file| (file, true)).chain([(&case, false)]);
        for (file, may_be_there) in all {
            let path = self.root().join(file.name);
            let error = match own::create_file(&path, file.text.as_bytes()) {
                Ok(()) => {
                    made.push(path);
                    continue;
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                    let same = || fs::read(&path).is_ok_and(|now| now == file.text.as_bytes());
                    if may_be_there && self.inside(&path).is_ok() && same() {
                        continue;
                    }
                    WorkspaceError::Exists(file.name.to_owned())
                }
                Err(error) => WorkspaceError::system("the file cannot be written")(error),
            };
            // Files of a case that could not be created are removed.
            made.iter().for_each(|path| drop(fs::remove_file(path)));
            return Err(error);
        }
        Ok(id_of(case.name))
    }
}

/// Identifier in requests for a path of the folder.
pub(super) fn id_of(shown: &str) -> String {
    fingerprint(shown.as_bytes())
}

/// Time of the last change of a file; 1970 if it is unknown.
pub(super) fn modified(about: &fs::Metadata) -> SystemTime {
    about.modified().unwrap_or(SystemTime::UNIX_EPOCH)
}

// Detection of the case files in the folder.

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

// Renaming, copying and deleting case files.

impl Workspace {
    /// Renames a case file and its draft within its folder. Returns its new id.
    ///
    /// # Errors
    /// A name that no case may have, an existing file, and errors of the system.
    pub(crate) fn rename(
        &self,
        case: &CaseFile,
        file_name: &str,
    ) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be renamed");
        let (shown, path) = self.neighbour(case, file_name)?;
        let draft = self.draft(case);
        {
            let _alone = self.writing();
            if fs::symlink_metadata(&path).is_ok() {
                return Err(WorkspaceError::Exists(file_name.to_owned()));
            }
            fs::rename(self.entry(case), &path).map_err(&failed)?;
        }
        let id = id_of(&shown);
        if let Some(draft) = draft {
            let renamed = CaseFile { id: id.clone(), shown, path, ..case.clone() };
            self.keep_draft(&renamed, draft.text, draft.base_revision)?;
            self.remove_draft(case)?;
        }
        Ok(id)
    }

    /// Copies a case file, as saved on disk, within its folder. Returns the new id.
    ///
    /// # Errors
    /// A name that no case may have, an existing file, and errors of the system.
    pub(crate) fn copy(&self, case: &CaseFile, file_name: &str) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be copied");
        let (shown, path) = self.neighbour(case, file_name)?;
        let _alone = self.writing();
        let bytes = fs::read(&case.path).map_err(&failed)?;
        own::create_file(&path, &bytes).map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => WorkspaceError::Exists(file_name.to_owned()),
            _ => failed(error),
        })?;
        Ok(id_of(&shown))
    }

    /// Removes a case file that is still at `revision`, and its draft. The files that it names
    /// stay, because other cases may name them, too.
    ///
    /// # Errors
    /// The file has changed since, and errors of the system.
    pub(crate) fn remove(&self, case: &CaseFile, revision: &str) -> Result<(), WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be deleted");
        let _alone = self.writing();
        let now = fs::read(&case.path).map_err(&failed)?;
        if fingerprint(&now) != revision {
            return Err(WorkspaceError::Changed);
        }
        fs::remove_file(self.entry(case)).map_err(&failed)?;
        self.remove_draft(case)
    }

    /// The path of a file with this name in the folder of a case: for display, and on disk.
    fn neighbour(
        &self,
        case: &CaseFile,
        file_name: &str,
    ) -> Result<(String, PathBuf), WorkspaceError> {
        check_case_name(file_name)?;
        let shown = match case.shown.rsplit_once('/') {
            Some((folder, _)) => format!("{folder}/{file_name}"),
            None => file_name.to_owned(),
        };
        let path = self.root().join(&shown);
        Ok((shown, path))
    }

    /// The directory entry itself: for a link the link, not its target.
    fn entry(&self, case: &CaseFile) -> PathBuf {
        self.root().join(&case.shown)
    }
}

// Names of new files: valid on every system, and without a path.

/// Device names reserved by Windows, with any extension.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "com", "lpt"];

/// Maximum length of a name, bytes, so that the prefix of the temporary file fits, too.
const LONGEST: usize = 200;

/// Refuses anything but a plain file name.
///
/// # Errors
/// The mistake of the name.
fn check_name(name: &str) -> Result<(), WorkspaceError> {
    match wrong(name) {
        None => Ok(()),
        Some(why) => Err(WorkspaceError::Name { name: name.chars().take(80).collect(), why }),
    }
}

/// The same, for names of case files.
///
/// # Errors
/// The mistake of the name.
fn check_case_name(name: &str) -> Result<(), WorkspaceError> {
    check_name(name)?;
    match name.to_ascii_lowercase().ends_with(".toml") {
        true => Ok(()),
        false => {
            let why = "a case file ends in `.toml`".into();
            Err(WorkspaceError::Name { name: name.to_owned(), why })
        }
    }
}

fn wrong(name: &str) -> Option<Cow<'static, str>> {
    let invisible = wholestring_case::invisible(name);
    let invisible = invisible.map(|letter| {
        let character = wholestring_case::described(letter);
        Cow::from(format!("it contains {character}; write it without"))
    });
    invisible.or_else(|| mistake(name).map(Cow::from))
}

/// The same for names of visible characters.
fn mistake(name: &str) -> Option<&'static str> {
    if name.is_empty() {
        return Some("it is empty");
    }
    if name.len() > LONGEST {
        return Some("it is longer than 200 bytes");
    }
    if name.chars().any(|letter| letter.is_control() || "/\\:*?\"<>|".contains(letter)) {
        return Some("it contains a separator or a character that file names cannot have");
    }
    if name.starts_with(['.', ' ', '-']) || name.ends_with(['.', ' ']) {
        return Some("it begins or ends with a dot, a space or a dash");
    }
    let stem = name.split('.').next().unwrap_or(name).trim_end().to_ascii_lowercase();
    let device = stem.trim_end_matches(|digit: char| digit.is_ascii_digit());
    let is_numbered = matches!(device, "com" | "lpt") && stem.len() == device.len() + 1;
    if is_numbered || (device == stem && DEVICES[..4].contains(&device)) {
        return Some("it is the name of a device");
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An editor that empties a file before it writes it does not make the case vanish; a file that
    /// stays empty is none.
    #[test]
    fn a_file_that_is_being_written_is_still_a_case() {
        let place = tempfile::tempdir().expect("a folder");
        let path = place.path().join("a.toml");
        fs::write(&path, "").expect("a file");
        let workspace = Workspace::open(place.path()).expect("a workspace");
        let id = id_of("a.toml");
        assert!(workspace.case(&id).is_err());
        thread::scope(|scope| {
            scope.spawn(|| {
                thread::sleep(Duration::from_millis(30));
                fs::write(&path, "[well]\nstations = []\n[[string]]\n").expect("a file");
            });
            assert!(workspace.case(&id).is_ok());
        });
    }

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

    #[test]
    fn plain_names_do_and_others_do_not() {
        for name in ["well.toml", "Bohrung 7 (neu).toml", "井.csv", "com.toml", "console.toml"] {
            assert_eq!(wrong(name), None, "{name}");
        }
        for name in [
            "",
            ".",
            "..",
            "../x.toml",
            "/etc/passwd",
            "a/b.toml",
            "a\\b.toml",
            "c:x.toml",
            "\\\\server\\share\\x.toml",
            "a\0.toml",
            "a\n.toml",
            ".hidden.toml",
            "well.toml.",
            "well.toml ",
            "NUL",
            "nul.toml",
            "COM1.toml",
            "lpt9.csv",
            "con .toml",
            "-o.toml",
        ] {
            assert!(wrong(name).is_some(), "{name:?}");
        }
        assert!(wrong(&"a".repeat(201)).is_some());
        let why = wrong("well\u{202e}7.toml").unwrap();
        assert!(why.contains("U+202E (right-to-left override)"), "{why}");
    }
}
