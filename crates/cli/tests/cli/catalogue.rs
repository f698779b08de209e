//! `catalogue`: entries that a case can name, found by words.

use crate::desk::{Desk, transcript};
use insta::assert_snapshot;

#[test]
fn search_by_size_weight_grade_and_kind() {
    let desk = Desk::new();
    for (name, words) in [
        ("pipe", &["catalogue", "5-1/2", "21.9"][..]),
        ("heavy_weight_in_field_units", &["catalogue", "HWDP", "--units", "field"]),
        ("casing", &["catalogue", "casing", "9 5/8", "--units", "field"]),
        ("collars", &["catalogue", "DC 6-1/2"]),
        ("premium", &["catalogue", "5", "19.5", "premium"]),
        ("graded_casing", &["catalogue", "casing", "9-5/8", "L-80", "--units", "field"]),
        ("coiled", &["catalogue", "coiled", "CT-110", "2-3/8"]),
        ("rig", &["catalogue", "rig", "--units", "field"]),
        ("nothing", &["catalogue", "6-1/3"]),
    ] {
        assert_snapshot!(name, transcript(&desk.run(words)));
    }
}

/// Entries of a user's file precede the built-in ones; a missing or invalid file is reported.
#[test]
fn a_catalogue_of_ones_own() {
    let desk = Desk::new();
    let pipe = "[[tubular]]\nname = \"rig 7 pipe\"\nod = \"5 in\"\nid = \"4.276 in\"\n\
                yield_strength = \"135 ksi\"\n";
    let liner = "[[casing]]\nname = \"rig 7 liner\"\nod = \"7 in\"\nid = \"6.094 in\"\n\
                 mass_per_length = \"32 lb/ft\"\nyield_strength = \"110 ksi\"\n";
    std::fs::write(desk.path("mine.toml"), format!("{pipe}{liner}")).unwrap();
    let with = ["catalogue", "--with", "mine.toml", "--units", "field"];
    let listed = |words: &[&str]| {
        let output = desk.done(&[&with[..], words].concat());
        String::from_utf8(output.stdout).unwrap()
    };
    let own = listed(&["rig 7"]);
    for expected in ["rig 7 pipe", "rig 7 liner", "Drill pipe\n", "Casing\n"] {
        assert!(own.contains(expected), "{own}");
    }
    // No built-in entry has this name, and no built-in source is listed.
    assert!(own.ends_with("Sources:\n  a catalogue of one's own\n"), "{own}");
    // With its diameters, its mass and its yield strength, before the built-in entries.
    let casings = listed(&["casing", "7"]);
    assert!(casings.contains("API Spec 5CT"), "{casings}");
    let at = casings.find("rig 7 liner").expect("a liner");
    assert!(at < casings.find("7 in 32.0 lb/ft").expect("API's"), "{casings}");
    let row = casings[at..].lines().next().unwrap();
    for number in ["7.000", "6.094", "5.969", "32.0", "110"] {
        assert!(row.contains(number), "{row} lacks {number}");
    }
    std::fs::write(desk.path("bad.toml"), liner.replace("6.094", "7.5")).unwrap();
    std::fs::write(desk.path("empty.toml"), "# nothing yet\n").unwrap();
    for (name, answer) in [
        ("none.toml", "none.toml"),
        ("bad.toml", "the inside diameter is not smaller than the outside diameter"),
        ("empty.toml", "the catalogue `empty.toml` is empty"),
    ] {
        let output = desk.run(&["catalogue", "--with", name]);
        let message = transcript(&output);
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(message.contains(answer), "{name}: {message}");
    }
}

/// Without a word, all entries are listed, with a table for each kind.
#[test]
fn all_of_it() {
    let output = Desk::new().run(&["catalogue"]);
    let text = String::from_utf8(output.stdout).unwrap();
    for heading in [
        "Drill pipe\n",
        "Heavy-weight drill pipe\n",
        "Drill collars\n",
        "Coiled tubing\n",
        "Casing\n",
        "Top drives (typical)\n",
        "Hoists (typical)\n",
    ] {
        assert_eq!(text.matches(heading).count(), 1, "{heading}");
    }
    assert!(text.lines().count() > 180, "{text}");
}
