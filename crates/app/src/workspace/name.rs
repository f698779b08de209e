//! Names of new files: valid on every system, and without a path.

use super::error::WorkspaceError;

/// Device names reserved by Windows, with any extension.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "com", "lpt"];

/// Maximum length of a name, bytes, so that the prefix of the temporary file fits, too.
const LONGEST: usize = 200;

/// Refuses anything but a plain file name.
///
/// # Errors
/// The mistake of the name.
pub(super) fn check(name: &str) -> Result<(), WorkspaceError> {
    match wrong(name) {
        None => Ok(()),
        Some(why) => Err(WorkspaceError::Name { name: name.chars().take(80).collect(), why }),
    }
}

/// The same, for names of case files.
///
/// # Errors
/// The mistake of the name.
pub(super) fn check_case(name: &str) -> Result<(), WorkspaceError> {
    check(name)?;
    match name.to_ascii_lowercase().ends_with(".toml") {
        true => Ok(()),
        false => {
            let why = "a case file ends in `.toml`";
            Err(WorkspaceError::Name { name: name.to_owned(), why })
        }
    }
}

fn wrong(name: &str) -> Option<&'static str> {
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
    use super::wrong;

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
    }
}
