use std::path::Path;

use wholestring_case::{Disk, InMemory};

use super::*;

fn cases() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

fn shipped(name: &str) -> String {
    std::fs::read_to_string(cases().join(name)).expect(name)
}

fn applied(
    text: &str,
    set: &[(&str, &str)],
    comments: &[(usize, Fate)],
) -> Result<Applied, Refusal> {
    let set = set.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    let comments = comments.iter().copied().collect();
    let applying = Applying { text: text.to_owned(), set, comments };
    applying.apply("case.toml", &Disk::beside(&cases().join("case.toml")))
}

/// A calibrated well: each section and each level of the plan keeps its own factor, and the
/// comments on the data of the fit are marked as those of the old factors.
#[test]
fn sections_keep_their_own_factors_and_comments_become_true() {
    let text = shipped("forge-16a.toml");
    let found = applied(&text, &[("friction_multiplier", "0.8")], &[]).expect("a valid case");
    let change = |key: &str| {
        let change = found.changes.iter().find(|change| change.key == key).expect(key);
        (change.label.as_str(), change.old.as_deref().expect("a value"), change.new.as_str())
    };
    assert_eq!(found.changes.len(), 12);
    assert_eq!(
        change("well.hole.0.friction.kinetic"),
        ("Friction, casing to 5110 ft", "0.097", "0.0776")
    );
    assert_eq!(
        change("well.hole.1.friction.around"),
        ("Friction around the hole, open hole to 10955 ft", "0.220", "0.176")
    );
    assert_eq!(
        change("plan.friction.high.open.kinetic"),
        ("Plan, high friction, open hole", "0.619", "0.4952")
    );
    let marked = "{ kinetic = 0.4272, around = 0.176 }  # was kinetic 0.534, around 0.220: \
        fitted on forge-16a-measured.csv";
    assert!(found.text.contains(marked), "{}", found.text);
    assert!(found.text.contains("# Before a change: low kinetic 0.050"), "{}", found.text);
    // Nothing else has changed.
    let same = |line: &&str| !text.contains(*line);
    let others: Vec<&str> = found.text.lines().filter(same).collect();
    assert_eq!(others.len(), 5, "{others:?}");
}

#[test]
fn a_factor_that_the_plan_forbids_is_refused_with_its_reason() {
    let text = format!("{}\n[plan.friction]\nlow = 0.1\nhigh = 0.4\n", shipped("slant.toml"));
    let refusal = applied(&text, &[("friction", "0.5")], &[]).expect_err("a refusal");
    assert_eq!((refusal.status, refusal.error.kind), (422, "unsound"));
    let reason = &refusal.error.diagnostics[0].message;
    assert!(reason.starts_with("expected friction is more than high friction: 0.5"), "{reason}");
    let found = applied(&text, &[("friction", "0.4")], &[]).expect("a valid case");
    assert_eq!(found.changes.len(), 2);
    let both = applied(&text, &[("friction", "0.3"), ("friction_multiplier", "1.1")], &[]);
    assert!(both.expect_err("a refusal").error.message.contains("exclude each other"));
}

/// Comments are treated as the reader decides, and an unchanged value is no change.
#[test]
fn a_reader_decides_about_comments() {
    let text = shipped("np13-x1042.toml");
    let set = [("friction", "0.25"), ("wob", "60 kN")];
    let proposed = applied(&text, &set, &[]).expect("a valid case");
    let line =
        proposed.comments.iter().find(|comment| comment.text.starts_with("the article varies"));
    let (line, fate) = line.map(|comment| (comment.line, comment.fate)).expect("a comment");
    assert_eq!(fate, Fate::Mark);
    let result = applied(&text, &set, &[(line, Fate::Keep)]).expect("a valid case");
    assert!(result.text.contains("friction = 0.25                  # the article varies it"));
    let unchanged = applied(&text, &[("friction", "0.3")], &[]).expect("a valid case");
    assert_eq!((unchanged.changes.len(), unchanged.text), (0, text));
}

#[test]
fn the_short_keys_are_written_where_they_belong() {
    let text = "[operation]\nkind = \"trip_out\"\n";
    let set = [("bit_depth".to_owned(), "300 m".to_owned())].into_iter().collect();
    let pairs = key_values(text, &set).expect("keys");
    assert_eq!(pairs, [("operation.bit_depth".to_owned(), "300 m".to_owned())]);
    let applying = Applying { text: text.to_owned(), set, comments: BTreeMap::new() };
    let refusal = applying.apply("case.toml", &InMemory::default()).expect_err("no case");
    assert!(!refusal.error.diagnostics.is_empty());
}
