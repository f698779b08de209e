//! Confinement to the folder.

use std::fs;

use serde_json::json;

use crate::common::{CASE, Served, link::symlink};

const STATIONS: &str =
    "stations = [[\"0 m\", \"0 deg\", \"0 deg\"], [\"1000 m\", \"30 deg\", \"0 deg\"]]";
const SURVEY: &str = "md (m),inc (deg),azi (deg)\n0,0,0\n1000,30,0\n";

#[test]
fn a_case_reads_no_file_outside() {
    let elsewhere = tempfile::tempdir().unwrap();
    let secret = elsewhere.path().join("secret.csv");
    fs::write(&secret, SURVEY).unwrap();
    let served = Served::with(&[("wells/a.toml", CASE), ("s.csv", SURVEY)]);
    symlink(&secret, served.path().join("wells/link.csv")).unwrap();
    symlink(elsewhere.path(), served.path().join("wells/out")).unwrap();
    let path = format!("/api/cases/{}/check", served.id("wells/a.toml"));
    let diagnostics = |survey: &str| {
        let text = CASE.replace(STATIONS, &format!("survey = '{survey}'"));
        served.post(&path, &json!({"text": text})).ok()["diagnostics"].clone()
    };
    let up = secret.strip_prefix("/").unwrap().display().to_string();
    let up = format!("{}{up}", "../".repeat(12));
    let outside = [
        secret.display().to_string(),
        up,
        "link.csv".into(),
        "out/secret.csv".into(),
        "/etc/passwd".into(),
    ];
    for survey in outside {
        let diagnostics = diagnostics(&survey);
        assert_eq!(diagnostics[0]["level"], "error");
        let label = diagnostics[0]["label"].as_str().unwrap();
        assert!(label.contains("it is outside the folder"), "{survey}: {diagnostics}");
        assert!(!diagnostics.to_string().contains("root:"));
    }
    for survey in ["\\\\server\\share\\s.csv", "file:///etc/passwd", "out", "."] {
        assert_eq!(diagnostics(survey)[0]["level"], "error", "{survey}");
    }
    // Next to the case and above it, inside the folder: those are read.
    assert_ne!(diagnostics("../s.csv")[0]["level"], "error");
}

#[test]
fn links_that_leave_are_no_cases() {
    let elsewhere = tempfile::tempdir().unwrap();
    fs::write(elsewhere.path().join("secret.toml"), CASE).unwrap();
    let served = Served::with(&[("a.toml", CASE)]);
    symlink(elsewhere.path().join("secret.toml"), served.path().join("b.toml")).unwrap();
    symlink(elsewhere.path(), served.path().join("out")).unwrap();
    symlink(served.path(), served.path().join("round")).unwrap();
    symlink(served.path().join("a.toml"), served.path().join("c.toml")).unwrap();
    let cases = served.get("/api/cases").ok();
    let paths: Vec<&str> =
        cases.as_array().unwrap().iter().map(|case| case["path"].as_str().unwrap()).collect();
    assert_eq!(paths, ["a.toml", "c.toml"]);
    // A case saved through a link inside the folder goes to its target; the link stays.
    let path = format!("/api/cases/{}", served.id("c.toml"));
    let revision = served.get(&path).ok()["revision"].clone();
    served.put(&path, &json!({"text": format!("{CASE}\n"), "revision": revision})).ok();
    assert!(served.path().join("c.toml").is_symlink());
    assert_eq!(fs::read_to_string(served.path().join("a.toml")).unwrap(), format!("{CASE}\n"));
}

#[test]
fn drafts_and_new_cases_stay_inside() {
    let elsewhere = tempfile::tempdir().unwrap();
    let served = Served::with(&[("a.toml", CASE)]);
    symlink(elsewhere.path(), served.path().join(".wholestring")).unwrap();
    let path = format!("/api/cases/{}/draft", served.id("a.toml"));
    let response = served.put(&path, &json!({"text": "x", "revision": ""}));
    assert_eq!(response.error(500), "failed");
    assert!(response.text().contains("it is outside the folder"));
    assert_eq!(fs::read_dir(elsewhere.path()).unwrap().count(), 0);
    // A dangling link counts as an existing file.
    symlink(elsewhere.path().join("new.toml"), served.path().join("b.toml")).unwrap();
    let new = json!({"file_name": "b.toml", "text": CASE});
    assert_eq!(served.post("/api/cases", &new).error(409), "conflict");
    assert!(!elsewhere.path().join("new.toml").exists());
}
