//! Temporary files of a server that was killed while it wrote.

use std::{fs, fs::File, path::Path};

use crate::common::{CASE, Served, link::symlink};

fn put(folder: &Path, names: &[&str]) {
    for name in names {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "half a ca").unwrap();
    }
}

#[test]
fn they_are_removed_at_the_next_start_and_nothing_else_is() {
    let own = [
        ".wholestring-aB3dE6.part",
        "wells/.wholestring-000000.part",
        ".wholestring/drafts/.wholestring-zzzzzz.part",
        ".wholestring/jobs/.wholestring-zzzzzz.part",
        ".wholestring/live/.wholestring-zzzzzz.part",
        ".wholestring/temporary/.tmpAbC123",
    ];
    let others = [
        ".wholestring-backup",
        ".wholestring-notes.toml",
        ".wholestring-my-own.part",
        ".wholestring-1234567.part",
        "wholestring-aB3dE6.part",
        ".tmpAbC123",
        "wells/.tmpAbC123",
        ".wholestring/drafts/0000.json",
        ".wholestring/temporary/notes.txt",
        ".wholestring-folder.part/a.txt",
        ".git/.wholestring-aB3dE6.part",
    ];
    let used = ".wholestring-inUse0.part";
    let elsewhere = tempfile::tempdir().unwrap();
    put(elsewhere.path(), &[".wholestring-aB3dE6.part"]);
    let mut served = Served::with(&[("wells/a.toml", CASE)]);
    let mut held = None;
    served.restart(|folder| {
        put(folder, &own);
        put(folder, &others);
        put(folder, &[used]);
        // Another server is writing it.
        let file = File::open(folder.join(used)).unwrap();
        file.try_lock().unwrap();
        held = Some(file);
        symlink(elsewhere.path(), folder.join("out")).unwrap();
        symlink(folder.join("wells/a.toml"), folder.join(".wholestring-linked.part")).unwrap();
    });
    for name in own {
        assert!(!served.path().join(name).exists(), "{name}");
    }
    for name in others.iter().chain(&[used, "wells/a.toml"]) {
        assert!(served.path().join(name).exists(), "{name}");
    }
    assert!(served.path().join(".wholestring-linked.part").is_symlink());
    assert!(elsewhere.path().join(".wholestring-aB3dE6.part").exists());
    drop(held);
    served.restart(|_| ());
    assert!(!served.path().join(used).exists());
}
