//! Examples of changes: patches in `docs/changes`, each of which adds one thing of a kind, and the
//! table of `CONTRIBUTING.md` with the number of files that such a change touches.
//!
//! The numbers in the table and in the patches are always compared. `scripts/changes.sh` applies,
//! compiles and tests the patches, because a patch becomes outdated with every edit of its context.

use std::path::PathBuf;

use crate::{
    command::{files, read, root},
    outcome::{Failure, Finding},
};

/// Folder of the patches, from the root of the repository.
const PATCHES: &str = "docs/changes";

/// File with the table.
const TABLE: &str = "CONTRIBUTING.md";

/// Beginning of a file's part of the difference.
const BEGIN: &str = "diff --git ";

/// A patch: a head in words, then its difference.
struct Patch {
    /// Its file's name, without the extension.
    name: String,
    head: String,
    /// The files that it changes.
    files: Vec<String>,
}

impl Patch {
    fn parse(name: &str, text: &str) -> Self {
        let start = match text.starts_with(BEGIN) {
            true => 0,
            false => text.find(&format!("\n{BEGIN}")).map_or(text.len(), |end| end + 1),
        };
        let (head, difference) = text.split_at(start);
        let file = |line: &str| Some(line.strip_prefix(BEGIN)?.split_once(" b/")?.1.to_owned());
        let files = difference.lines().filter_map(file).collect();
        Self { name: name.to_owned(), head: head.to_owned(), files }
    }

    /// Its path, from the root of the repository.
    fn file(&self) -> String {
        format!("{PATCHES}/{}.patch", self.name)
    }

    /// The sources that have to be written by hand: not the output of commands (the lock file,
    /// snapshots), nor tests and pages, which every change has.
    fn by_hand(&self) -> Vec<&str> {
        let is_by_hand = |file: &&str| {
            let is_test = file.split('/').any(|part| part == "tests" || part == "tests.rs");
            !is_test && ![".lock", ".snap", ".md"].iter().any(|end| file.ends_with(end))
        };
        self.files.iter().map(String::as_str).filter(is_by_hand).collect()
    }
}

/// Every row of the table has the number of files that its patch changes, and every patch has a
/// row.
pub(crate) fn check_table() -> Result<Finding, Failure> {
    let parsed = |(path, text): (PathBuf, String)| {
        Patch::parse(&path.file_stem().unwrap_or_default().to_string_lossy(), &text)
    };
    let patches = files(&root().join(PATCHES), "patch")?.into_iter().map(parsed);
    let patches: Vec<Patch> = patches.collect();
    let faults = faults(&read(&root().join(TABLE))?, &patches);
    if faults.is_empty() { Ok(Finding::Done) } else { Err(Failure::new(faults.join("\n"))) }
}

/// Errors in the table or in a patch's head, each in a sentence.
fn faults(text: &str, patches: &[Patch]) -> Vec<String> {
    // Rows that link a patch: its name, and the number of files as written.
    let row = |line: &'_ str| -> Option<(String, String)> {
        let mut cells = line.strip_prefix('|')?.split('|').map(str::trim);
        let (_, link) = cells.next()?.split_once("](docs/changes/")?;
        Some((link.strip_suffix(".patch)")?.to_owned(), cells.next()?.to_owned()))
    };
    let rows: Vec<(String, String)> = text.lines().filter_map(row).collect();
    let unknown = rows.iter().filter(|row| !patches.iter().any(|patch| patch.name == row.0));
    let mut faults: Vec<String> = unknown
        .map(|(name, _)| format!("{TABLE} names {PATCHES}/{name}.patch, which is not there"))
        .collect();
    for patch in patches {
        let (file, by_hand) = (patch.file(), patch.by_hand());
        match rows.iter().find(|row| row.0 == patch.name) {
            None => faults.push(format!("the table in {TABLE} has no row of {file}")),
            Some((_, files)) if files.parse() == Ok(by_hand.len()) => {}
            Some((_, files)) => faults.push(format!(
                "{file} touches {} files written by hand ({}), {TABLE} has `{files}`",
                by_hand.len(),
                by_hand.join(", "),
            )),
        }
        let missing = by_hand.iter().filter(|part| !patch.head.contains(**part));
        faults.extend(
            missing
                .map(|part| format!("the head of {file} does not describe the change of {part}")),
        );
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATCH: &str = "\
A key: `x`.

crates/core/src/x.rs  the number
Tests: --test x one
Tests: --lib two

diff --git a/crates/core/src/x.rs b/crates/core/src/x.rs
index 123..456 100644
--- a/crates/core/src/x.rs
+++ b/crates/core/src/x.rs
@@ -1,2 +1,2 @@
-diff --git a/no b/no
+1
diff --git a/crates/core/src/x/tests.rs b/crates/core/src/x/tests.rs
diff --git a/crates/core/tests/x.rs b/crates/core/tests/x.rs
diff --git a/crates/core/tests/snapshots/x.snap b/crates/core/tests/snapshots/x.snap
diff --git a/Cargo.lock b/Cargo.lock
diff --git a/docs/src/x.md b/docs/src/x.md
";

    #[test]
    fn a_patch_has_a_head_and_files() {
        let patch = Patch::parse("key", PATCH);
        assert!(patch.head.ends_with("two\n\n"), "{}", patch.head);
        assert_eq!(patch.files.len(), 6);
        assert_eq!(patch.by_hand(), ["crates/core/src/x.rs"]);
        let bare = Patch::parse("key", "diff --git a/x b/y\n");
        assert_eq!((bare.head.as_str(), &bare.files[..]), ("", &["y".to_owned()][..]));
    }

    #[test]
    fn table_and_patches_agree() {
        let table = |files: &str| format!("| [a key](docs/changes/key.patch) | {files} | it |\n");
        let patches = [Patch::parse("key", PATCH)];
        assert!(faults(&table("1"), &patches).is_empty());
        for (text, expected) in [
            (
                table("2"),
                "docs/changes/key.patch touches 1 files written by hand (crates/core/src/x.rs), \
                 CONTRIBUTING.md has `2`",
            ),
            (String::new(), "the table in CONTRIBUTING.md has no row of docs/changes/key.patch"),
            (
                table("1") + &table("1").replace("key.patch", "other.patch"),
                "CONTRIBUTING.md names docs/changes/other.patch, which is not there",
            ),
        ] {
            assert_eq!(faults(&text, &patches), [expected]);
        }
        let silent = [Patch::parse("key", &PATCH.replace("crates/core/src/x.rs  ", ""))];
        assert_eq!(
            faults(&table("1"), &silent),
            ["the head of docs/changes/key.patch does not describe the change of \
              crates/core/src/x.rs"]
        );
    }
}
