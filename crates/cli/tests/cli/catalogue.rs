//! `catalogue`: what a case can name, found by its words.

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

/// Without a word there is everything, and each kind has its table.
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
