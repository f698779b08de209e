use std::{collections::BTreeSet, env, fs, path::PathBuf, process};

use super::{patch::Patch, table::faults, tree::copy};

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

fn table(files: &str) -> String {
    format!("| to add | files |\n|---|---|\n| [a key](docs/changes/key.patch) | {files} | it |\n")
}

#[test]
fn a_patch_has_a_head_tests_and_files() {
    let patch = Patch::parse("key", PATCH);
    assert!(patch.head.ends_with("two\n\n"), "{}", patch.head);
    assert_eq!(patch.tests().collect::<Vec<_>>(), ["--test x one", "--lib two"]);
    assert_eq!(patch.files.len(), 6);
    assert_eq!(patch.by_hand(), ["crates/core/src/x.rs"]);
    let bare = Patch::parse("key", "diff --git a/x b/y\n");
    assert_eq!((bare.head.as_str(), &bare.files[..]), ("", &["y".to_owned()][..]));
}

#[test]
fn table_and_patches_say_the_same() {
    let patches = [Patch::parse("key", PATCH)];
    assert!(faults(&table("1"), &patches).is_empty());
    for (text, expected) in [
        (
            table("2"),
            "docs/changes/key.patch touches 1 files written by hand (crates/core/src/x.rs), \
             CONTRIBUTING.md says `2`",
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
        ["the head of docs/changes/key.patch does not describe the change of crates/core/src/x.rs"]
    );
}

#[test]
fn a_copy_has_the_files_and_no_others() {
    let place = env::temp_dir().join(format!("changes-{}", process::id()));
    let [from, to] = ["from", "to"].map(|name| place.join(name));
    let write = |path: PathBuf, text: &str| {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    for name in ["a/one", "two"] {
        write(from.join(name), name);
    }
    write(to.join("two"), "other");
    write(to.join("new/crate/three"), "a patch made it");
    let files = BTreeSet::from(["a/one".into(), "two".into()]);
    copy(&from, &to, &files).unwrap();
    let found = |name: &str| fs::read_to_string(to.join(name)).unwrap();
    assert_eq!([found("a/one"), found("two")], ["a/one", "two"]);
    assert!(!to.join("new").exists());
    let time = || fs::metadata(to.join("two")).unwrap().modified().unwrap();
    let before = time();
    copy(&from, &to, &files).unwrap();
    assert_eq!(time(), before);
    fs::remove_dir_all(&place).unwrap();
}
