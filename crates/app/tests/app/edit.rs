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
