//! Names of new files: such as every system takes, and no paths.

use super::error::WorkspaceError;

/// What Windows keeps for devices, with any ending.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "com", "lpt"];

/// A name is no longer, bytes: what is put in front of it while it is written fits, too.
const LONGEST: usize = 200;

/// Refuses what is no plain name of a file.
///
/// # Errors
/// What is wrong with the name.
pub(super) fn check(name: &str) -> Result<(), WorkspaceError> {
    match wrong(name) {
        None => Ok(()),
        Some(why) => Err(WorkspaceError::Name { name: name.chars().take(80).collect(), why }),
    }
}

/// The same, and what is no name of a case file.
///
/// # Errors
/// What is wrong with the name.
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
        return Some("it holds a separator or a character that no name of a file has");
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
