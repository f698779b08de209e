//! Renaming, copying and deleting cases.

use std::fs;

use serde_json::{Value, json};

use crate::common::{CASE, Served, link::symlink};

fn path(served: &Served, place: &str) -> String {
    format!("/api/cases/{}", served.id(place))
}

fn paths(served: &Served) -> Vec<String> {
    let cases = served.get("/api/cases").ok();
    let path = |case: &Value| case["path"].as_str().unwrap().to_owned();
    cases.as_array().unwrap().iter().map(path).collect()
}

#[test]
fn a_renamed_case_keeps_its_draft_and_its_folder() {
    let served = Served::with(&[("wells/a.toml", CASE), ("wells/b.toml", CASE)]);
    let a = path(&served, "wells/a.toml");
    let revision = served.get(&a).ok()["revision"].clone();
    served.put(&format!("{a}/draft"), &json!({"text": "half", "revision": revision})).ok();
    let rename = |name: &str| served.post(&format!("{a}/rename"), &json!({"file_name": name}));
    assert_eq!(rename("b.toml").error(409), "conflict");
    for name in ["../c.toml", "x/c.toml", "c.txt", ""] {
        assert_eq!(rename(name).error(422), "bad_input", "{name:?}");
    }
    assert_eq!(paths(&served), ["wells/a.toml", "wells/b.toml"]);
    let id = rename("c.toml").ok()["id"].clone();
    assert_eq!(id, served.id("wells/c.toml"));
    assert_eq!(paths(&served), ["wells/b.toml", "wells/c.toml"]);
    assert_eq!(served.get(&path(&served, "wells/c.toml")).ok()["draft"]["text"], "half");
    assert_eq!(rename("d.toml").error(404), "not_found");
    // The draft has moved with it: a new case of the old name has none.
    fs::write(served.path().join("wells/a.toml"), CASE).unwrap();
    assert_eq!(served.get(&a).ok()["draft"], Value::Null);
}

#[test]
fn a_copy_goes_over_none() {
    let served = Served::with(&[("wells/a.toml", CASE), ("wells/b.toml", "[well]\n")]);
    let a = path(&served, "wells/a.toml");
    let copy = |name: &str| served.post(&format!("{a}/copy"), &json!({"file_name": name}));
    assert_eq!(copy("b.toml").error(409), "conflict");
    assert_eq!(fs::read_to_string(served.path().join("wells/b.toml")).unwrap(), "[well]\n");
    let id = copy("c.toml").ok()["id"].clone();
    assert_eq!(id, served.id("wells/c.toml"));
    assert_eq!(fs::read_to_string(served.path().join("wells/c.toml")).unwrap(), CASE);
}

#[test]
fn what_has_changed_is_not_deleted() {
    let survey = "md (m),inc (deg),azi (deg)\n0,0,0\n1000,30,0\n";
    let served = Served::with(&[("a.toml", CASE), ("s.csv", survey)]);
    let a = path(&served, "a.toml");
    let revision = served.get(&a).ok()["revision"].as_str().unwrap().to_owned();
    served.put(&format!("{a}/draft"), &json!({"text": "half", "revision": revision})).ok();
    assert_eq!(served.delete(&format!("{a}?revision=0")).error(409), "conflict");
    assert_eq!(paths(&served), ["a.toml"]);
    assert_eq!(served.delete(&format!("{a}?revision={revision}")).status, 204);
    assert_eq!(paths(&served), [""; 0]);
    assert_eq!(fs::read_dir(served.path().join(".wholestring/drafts")).unwrap().count(), 0);
    assert!(served.path().join("s.csv").exists());
}

#[test]
fn of_a_link_the_link_goes() {
    let served = Served::with(&[("a.toml", CASE)]);
    symlink(served.path().join("a.toml"), served.path().join("b.toml")).unwrap();
    let b = path(&served, "b.toml");
    served.post(&format!("{b}/rename"), &json!({"file_name": "c.toml"})).ok();
    assert!(served.path().join("c.toml").is_symlink());
    let c = path(&served, "c.toml");
    let revision = served.get(&c).ok()["revision"].as_str().unwrap().to_owned();
    assert_eq!(served.delete(&format!("{c}?revision={revision}")).status, 204);
    assert_eq!(paths(&served), ["a.toml"]);
}
