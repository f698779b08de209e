//! `new`: a case to start from.

use std::time::Instant;

use crate::desk::{Desk, transcript};
use insta::assert_snapshot;

/// It is valid without a warning and runs unchanged; every line with a value is explained.
#[test]
fn a_new_case_runs() {
    let desk = Desk::new();
    assert_snapshot!("new_case", transcript(&desk.run(&["new", "north-1"])));
    let text = desk.text("north-1.toml");
    assert!(text.contains("name = \"north-1\""), "{text}");
    assert_snapshot!("new_case_checked", transcript(&desk.run(&["check", "north-1.toml"])));
    let start = Instant::now();
    desk.done(&["run", "north-1.toml", "-o", "out"]);
    // A second on an idle machine; a loaded one may take longer.
    assert!(start.elapsed().as_secs() < 60);
    assert_eq!(desk.summary("out").operations.len(), 5);
}

/// Its dynamics are not requested, but valid.
#[test]
fn its_dynamics_are_sound() {
    let desk = Desk::new();
    desk.run(&["new"]);
    let check = desk.done(&["check", "my-well.toml", "--set", "model=dynamic"]);
    assert!(check.stderr.is_empty(), "{}", transcript(&check));
}

/// Each key of the file has a comment, unless it repeats a key that has one.
#[test]
fn every_line_is_explained() {
    let desk = Desk::new();
    desk.run(&["new", "explained"]);
    let text = desk.text("explained.toml");
    let mut explained = std::collections::BTreeSet::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let Some((key, _)) = line.split_once(" = ") else {
            continue;
        };
        if line.contains("# ") {
            explained.insert(key.to_owned());
        }
        assert!(explained.contains(key), "{line}");
    }
    assert!(explained.len() > 20, "{explained:?}");
}

#[test]
fn nothing_is_written_over() {
    let desk = Desk::new();
    let before = desk.text("slant.toml");
    for name in ["slant", "slant.toml"] {
        assert_snapshot!("new_case_that_is_there", transcript(&desk.run(&["new", name])));
    }
    assert_eq!(desk.text("slant.toml"), before);
    assert_snapshot!(
        "new_case_in_no_folder",
        transcript(&desk.run(&["new", "no-such-folder/well"]))
    );
}

/// A name is a TOML string, whatever its characters.
#[test]
fn a_name_with_a_point_and_quotes() {
    let desk = Desk::new();
    for name in ["well 1.2", "Bob's 'best' well"] {
        desk.done(&["new", name]);
        desk.done(&["check", &format!("{name}.toml")]);
    }
}
