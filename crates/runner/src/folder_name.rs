//! Valid folder names for any name of a case.

use std::path::{Path, PathBuf};

/// Default folder of results, `out/<case name>`.
pub(crate) fn default_output(root: &Path, name: &str) -> PathBuf {
    root.join("out").join(file_name(name))
}

/// The name without characters that are invalid in file names on any system.
pub(crate) fn file_name(name: &str) -> String {
    const LONGEST: usize = 100;
    // Most systems allow 255 bytes, and a letter may take four; this leaves space for a number
    // after the name.
    const MAX_BYTES: usize = 240;
    let mut valid: String = name
        .chars()
        .map(|letter| match letter {
            '<' | '>' | ':' | '"' | '/' | '\\' | '|' | '?' | '*' => '-',
            letter if letter.is_control() => '-',
            letter => letter,
        })
        .take(LONGEST)
        .collect();
    while valid.len() > MAX_BYTES {
        valid.pop();
    }
    // Windows drops dots and blanks at the end, and `.` and `..` are folders already.
    let mut folder = valid.trim_start().trim_end_matches(['.', ' ']).to_owned();
    if folder.is_empty() || is_device(&folder) {
        folder.insert(0, '_');
    }
    folder
}

/// Whether Windows reserves the name for a device, regardless of the text after its first dot.
fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or(name).trim_end().to_ascii_uppercase();
    let numbered = |prefix: &str| {
        stem.strip_prefix(prefix)
            .is_some_and(|rest| rest.len() == 1 && rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    matches!(stem.as_str(), "CON" | "PRN" | "AUX" | "NUL") || numbered("COM") || numbered("LPT")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hundred letters of four bytes each would exceed the limit of every system.
    #[test]
    fn names_are_cut_by_their_bytes_too() {
        let name = file_name(&"𐍈".repeat(150));
        assert_eq!(name, "𐍈".repeat(60));
        let place = tempfile::tempdir().expect("a folder");
        std::fs::create_dir(place.path().join(format!("{name}-1000"))).expect("a folder");
        assert_eq!(file_name(&"a".repeat(150)), "a".repeat(100));
        assert_eq!(file_name(&format!("a{}", "ü".repeat(150))).len(), 199);
    }

    #[test]
    fn case_names_make_folders_on_every_system() {
        for (name, folder) in [
            ("NP13-X1042 at total depth", "NP13-X1042 at total depth"),
            ("a/b\\c: 12-1/4\" <x>", "a-b-c- 12-1-4- -x-"),
            ("..", "_"),
            ("", "_"),
            (" well. ", "well"),
            ("nul", "_nul"),
            ("Com1.5 m", "_Com1.5 m"),
            ("common", "common"),
            ("Bohrung Süd\n", "Bohrung Süd-"),
        ] {
            let here = default_output(Path::new(""), name);
            assert_eq!(here, Path::new("out").join(folder), "{name}");
        }
        let long = default_output(Path::new(""), &"é".repeat(500));
        assert_eq!(long.as_os_str().len(), 4 + 200);
        assert_eq!(default_output(Path::new("wells"), "a"), Path::new("wells/out/a"));
    }
}
