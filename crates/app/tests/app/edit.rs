//! Changes to a text.

use serde_json::json;

use crate::common::{CASE, Served};

#[test]
fn comments_stay() {
    let served = Served::with(&[("a.toml", CASE)]);
    let path = format!("/api/cases/{}/edit", served.id("a.toml"));
    let collar = json!({"component": "collar", "length": "30 m"});
    let changes = json!([
        {"set": "well.hole.0.friction", "to": 0.25},
        {"insert": "string", "at": 0, "value": collar},
        {"move": "string", "from": 0, "to": 1},
        {"remove": "string.1"},
        {"remove": "name"}
    ]);
    let edited = served.post(&path, &json!({"text": CASE, "changes": changes})).ok();
    let expected = CASE.replace("0.3  # a guess", "0.25  # a guess");
    let expected = expected.replace("# A slant well.\nname = \"slant\"\n", "");
    assert_eq!(edited["text"].as_str().unwrap(), expected);

    let post = |changes| served.post(&path, &json!({"text": CASE, "changes": changes}));
    let missing = post(json!([{"remove": "well.hole.7"}]));
    assert_eq!(missing.error(422), "bad_input");
    assert!(missing.text().contains("`well.hole.7` cannot be changed: there is no `7`"));
    let unknown = post(json!([{"delete": "name"}]));
    assert_eq!(unknown.error(422), "bad_json");
    assert!(unknown.text().contains("a change is {set, to}"), "{}", unknown.text());
}

#[test]
fn values_that_were_tried_are_shown_before_they_are_written() {
    let served = Served::with(&[("a.toml", CASE)]);
    let path = format!("/api/cases/{}/apply", served.id("a.toml"));
    let set = json!({"friction_multiplier": "0.8"});
    let applied = served.post(&path, &json!({"text": CASE, "set": set})).ok();
    let changes = applied["changes"].as_array().unwrap();
    assert_eq!(changes.len(), 1);
    assert_eq!(changes[0]["key"], "well.hole.0.friction");
    assert_eq!((&changes[0]["old"], &changes[0]["new"]), (&json!("0.3"), &json!("0.24")));
    assert_eq!(applied["comments"][0]["fate"], "keep");
    let expected = CASE.replace("0.3  # a guess", "0.24  # a guess");
    assert_eq!(applied["text"].as_str().unwrap(), expected);
    assert_eq!(std::fs::read_to_string(served.path().join("a.toml")).unwrap(), CASE);
    let wrong = served.post(&path, &json!({"text": CASE, "set": {"friction": "7"}}));
    assert_eq!(wrong.error(422), "unsound");
    assert!(wrong.text().contains("`friction` is too large"), "{}", wrong.text());
}
