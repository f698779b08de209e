//! Cases and drafts of a folder.

use std::{
    fs, thread,
    time::{Duration, Instant},
};

use serde_json::{Value, json};
use wholestring_case::InMemory;

use crate::common::{CASE, Served};

#[test]
fn a_folder_shows_its_cases() {
    let broken = CASE.replace("friction = 0.3", "friction = -1");
    let served = Served::with(&[
        ("b.toml", CASE),
        ("wells/a.toml", &broken),
        ("wells/no-toml.toml", "name = \"half\"\n[well]\nsurvey = "),
        ("Cargo.toml", "[package]\nname = \"well\"\n"),
        ("notes.txt", CASE),
        (".hidden/a.toml", CASE),
        ("target/a.toml", CASE),
        ("node_modules/a.toml", CASE),
        ("out/slant/summary.json", "{}"),
        ("out/slant/case.toml", CASE),
        ("1/2/3/4/deep.toml", CASE),
        ("1/2/3/4/5/deeper.toml", CASE),
    ]);
    let cases = served.get("/api/cases").ok();
    let values = |key: &str| -> Vec<Value> {
        cases.as_array().unwrap().iter().map(|case| case[key].clone()).collect()
    };
    assert_eq!(
        values("path"),
        ["1/2/3/4/deep.toml", "b.toml", "wells/a.toml", "wells/no-toml.toml"]
    );
    assert_eq!(values("name"), ["slant", "slant", "slant", "no-toml"]);
    assert_eq!(values("has_draft"), [false, false, false, false]);
    let problems = values("problem");
    assert_eq!(problems[..2], [Value::Null, Value::Null]);
    assert!(problems[2].as_str().unwrap().contains("friction"), "{problems:?}");
    assert_eq!(problems[3], "a value is missing after `=`");
    assert!(values("modified_ms").iter().all(|time| time.as_u64().unwrap() > 1_600_000_000_000));
    // The ids are the same in a later request.
    let later = served.get("/api/cases").ok();
    let ids: Vec<_> = later.as_array().unwrap().iter().map(|case| case["id"].clone()).collect();
    assert_eq!(ids, values("id"));
}

/// The cases once everything about them is computed.
fn complete(served: &Served, query: &str) -> Value {
    let end = Instant::now() + Duration::from_secs(60);
    loop {
        let cases = served.get(&format!("/api/cases{query}")).ok();
        if cases.as_array().unwrap().iter().all(|case| case["is_pending"] == false) {
            return cases;
        }
        assert!(Instant::now() < end, "{cases}");
        thread::sleep(Duration::from_millis(20));
    }
}

/// The overview is the judge's verdict on the answer of the soft string, and follows the files.
#[test]
fn a_case_has_an_overview() {
    let case = CASE.replace(
        "stations = [[\"0 m\", \"0 deg\", \"0 deg\"], [\"1000 m\", \"30 deg\", \"0 deg\"]]",
        "survey = \"s.csv\"",
    ) + "\n[rig]\nhoist_capacity = \"50 tf\"\n";
    let survey = "md (m),inc (deg),azi (deg)\n0,0,0\n1000,30,0\n";
    let invalid = case.replace("friction = 0.3", "friction = -1");
    let files = [("a.toml", case.as_str()), ("b.toml", &invalid), ("s.csv", survey)];
    let served = Served::with(&files);
    let cases = complete(&served, "");
    let (valid, invalid) = (&cases[0], &cases[1]);
    assert_eq!((&invalid["overview"], &invalid["silhouette"]), (&Value::Null, &Value::Null));
    let answer = json!({"text": case, "models": ["soft"]});
    let path = format!("/api/cases/{}/answer", served.id("a.toml"));
    let answer = served.post(&path, &answer).ok();
    let overview = &valid["overview"];
    let mut operations = answer["operations"].as_array().unwrap().iter();
    let own = operations.find(|one| one["operation"] == overview["operation"]).unwrap();
    assert_eq!(own["hook_load_N"], overview["hook_load_N"]);
    let worst = &overview["check"];
    let mut checks = own["checks"].as_array().unwrap().iter();
    let check = checks.find(|check| check["sentence"] == worst["sentence"]);
    let check = check.unwrap_or_else(|| panic!("{overview}"));
    assert_eq!((&check["severity"], &check["verdict"]), (&worst["severity"], &worst["verdict"]));
    let tvd_m = |cases: &Value| {
        let depths = cases[0]["silhouette"]["tvd_m"].as_array().unwrap();
        depths.last().unwrap().as_f64().unwrap()
    };
    let shallow_m = tvd_m(&cases);
    // Sentences are in the requested units; an unknown set of units is refused.
    let field = complete(&served, "?units=field");
    assert_ne!(field[0]["overview"]["check"]["sentence"], worst["sentence"]);
    assert_eq!(field[0]["overview"]["hook_load_N"], overview["hook_load_N"]);
    assert_eq!(served.get("/api/cases?units=none").error(422), "bad_input");
    // The survey is another file: its change is a change of the case.
    fs::write(served.path().join("s.csv"), "md (m),inc (deg),azi (deg)\n0,0,0\n1000,0.5,0\n")
        .unwrap();
    assert!(tvd_m(&complete(&served, "")) > shallow_m + 1.0);
}

/// A folder of many cases is listed at once, and its overviews follow.
#[test]
fn many_cases_are_listed_before_they_are_solved() {
    let names: Vec<String> = (0..60).map(|number| format!("{number:03}.toml")).collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (name.as_str(), CASE)).collect();
    let served = Served::with(&files);
    let cases = served.get("/api/cases").ok();
    assert_eq!(cases.as_array().unwrap().len(), 60);
    let complete = complete(&served, "");
    let mut cases = complete.as_array().unwrap().iter();
    assert!(
        cases.all(|case| case["overview"]["hook_load_N"].is_number() && case["name"] == "slant")
    );
}

/// A valid file may be a well that cannot be drilled: the list has the judge's verdict from the
/// newest result, and whether the case is unchanged since then.
#[test]
fn a_case_has_the_verdict_of_its_newest_result() {
    let served = Served::with(&[("a.toml", CASE)]);
    let verdict = || served.get("/api/cases").ok()[0]["verdict"].clone();
    assert_eq!(verdict(), Value::Null);
    let case = wholestring_case::parse("a.toml", CASE.as_bytes(), &InMemory::default(), &[]);
    let settings = case.expect("a valid case").settings;
    let checks = json!([
        {"kind": "goes_down", "severity": "error", "verdict": "error",
            "sentence": "The string does not go down."},
        {"kind": "tension", "severity": "ok", "verdict": "OK", "sentence": "Tension"}]);
    let summary = json!({"case": "slant", "settings": settings,
        "operations": [{"operation": "trip_in", "model": "soft", "checks": checks}]});
    let folder = served.path().join("out/a");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("summary.json"), summary.to_string()).unwrap();
    let found = verdict();
    assert_eq!((&found["severity"], &found["is_current"]), (&json!("error"), &json!(true)));
    assert_eq!(found["words"], "The string does not go down.");
    fs::write(served.path().join("a.toml"), CASE.replace("1.2 sg", "1.3 sg")).unwrap();
    assert_eq!(verdict()["is_current"], false);
}

#[test]
fn a_case_is_opened_and_saved() {
    let case = CASE.replace(
        "stations = [[\"0 m\", \"0 deg\", \"0 deg\"], [\"1000 m\", \"30 deg\", \"0 deg\"]]",
        "survey = \"s.csv\"",
    );
    let survey = "md (m),inc (deg),azi (deg)\n0,0,0\n1000,30,0\n";
    let served = Served::with(&[("wells/a.toml", &case), ("wells/s.csv", survey)]);
    let path = format!("/api/cases/{}", served.id("wells/a.toml"));
    let open = served.get(&path).ok();
    assert_eq!(open["text"], case.as_str());
    assert_eq!((&open["path"], &open["draft"]), (&json!("wells/a.toml"), &Value::Null));
    assert_eq!(open["beside"], json!(["s.csv"]));

    let changed = case.replace("1.2 sg", "1.3 sg");
    let saved = served.put(&path, &json!({"text": changed, "revision": open["revision"]})).ok();
    assert_ne!(saved["revision"], open["revision"]);
    let file = served.path().join("wells/a.toml");
    assert_eq!(fs::read_to_string(&file).unwrap(), changed);
    assert_eq!(served.get(&path).ok()["revision"], saved["revision"]);

    // Another client has written it since.
    let other = served.put(&path, &json!({"text": "lost", "revision": open["revision"]}));
    assert_eq!(other.error(409), "conflict");
    assert_eq!(fs::read_to_string(&file).unwrap(), changed);
    // Nothing else is left in the folder.
    assert_eq!(fs::read_dir(served.path().join("wells")).unwrap().count(), 2);
}

#[test]
fn a_draft_is_kept_until_the_case_is_saved() {
    let served = Served::with(&[("a.toml", CASE)]);
    let id = served.id("a.toml");
    let (path, draft_path) = (format!("/api/cases/{id}"), format!("/api/cases/{id}/draft"));
    let revision = served.get(&path).ok()["revision"].clone();
    let typed = json!({"text": "half a ca", "revision": revision});
    served.put(&draft_path, &typed).ok();
    served.put(&draft_path, &typed).ok();
    let draft = &served.get(&path).ok()["draft"];
    assert_eq!((&draft["text"], &draft["base_revision"]), (&json!("half a ca"), &revision));
    assert_eq!(served.get("/api/cases").ok()[0]["has_draft"], true);
    assert_eq!(fs::read_to_string(served.path().join("a.toml")).unwrap(), CASE);

    served.delete(&draft_path).ok();
    served.delete(&draft_path).ok();
    assert_eq!(served.get(&path).ok()["draft"], Value::Null);

    served.put(&draft_path, &typed).ok();
    served.put(&path, &json!({"text": CASE, "revision": revision})).ok();
    assert_eq!(served.get(&path).ok()["draft"], Value::Null);
}

#[test]
fn a_new_case_goes_over_none() {
    let served = Served::with(&[("a.toml", CASE), ("s.csv", "md,inc,azi\n")]);
    let new = |name: &str, beside: Value| {
        served.post("/api/cases", &json!({"file_name": name, "text": CASE, "beside": beside}))
    };
    let id = new("b.toml", json!([{"file_name": "t.csv", "text": "md\n"}])).ok()["id"].clone();
    assert_eq!(id, served.id("b.toml"));
    assert_eq!(fs::read_to_string(served.path().join("t.csv")).unwrap(), "md\n");
    assert_eq!(new("a.toml", json!([])).error(409), "conflict");
    // An existing file with other contents keeps them, and nothing is partially created.
    let files = json!([{"file_name": "u.csv", "text": ""}, {"file_name": "s.csv", "text": "x"}]);
    assert_eq!(new("c.toml", files).error(409), "conflict");
    assert!(!served.path().join("u.csv").exists() && !served.path().join("c.toml").exists());
    assert_eq!(fs::read_to_string(served.path().join("s.csv")).unwrap(), "md,inc,azi\n");
    // With the same contents it is accepted.
    new("c.toml", json!([{"file_name": "s.csv", "text": "md,inc,azi\n"}])).ok();
    for name in
        ["../d.toml", "/tmp/d.toml", "d/e.toml", "d\\e.toml", "d.txt", "nul.toml", "d\0.toml", ""]
    {
        assert_eq!(new(name, json!([])).error(422), "bad_input", "{name:?}");
    }
    // Characters that show a name as another one.
    for letter in
        "\u{202a}\u{202b}\u{202c}\u{202d}\u{202e}\u{2066}\u{2067}\u{2068}\u{2069}\u{200b}\u{200e}"
            .chars()
    {
        let name = format!("d{letter}lmot.toml");
        let refused = new(&name, json!([]));
        assert_eq!(refused.error(422), "bad_input", "{name:?}");
        let code = format!("U+{:04X}", u32::from(letter));
        let text = refused.json()["error"]["message"].as_str().unwrap().to_owned();
        assert!(text.contains(&code) && text.contains("invisible"), "{text}");
        assert!(!text.contains(letter), "{text}");
        let path = format!("/api/cases/{}", served.id("a.toml"));
        for action in ["rename", "copy"] {
            let refused = served.post(&format!("{path}/{action}"), &json!({"file_name": name}));
            assert_eq!(refused.error(422), "bad_input", "{action}: {name:?}");
        }
        let beside = json!([{"file_name": format!("s{letter}.csv"), "text": ""}]);
        assert_eq!(new("d.toml", beside).error(422), "bad_input");
        let named = CASE.replace("\"slant\"", &format!("\"sla{letter}nt\""));
        let checked = served.post(&format!("{path}/check"), &json!({"text": named})).ok();
        let diagnostics = checked["diagnostics"].to_string();
        assert!(diagnostics.contains(&code), "{diagnostics}");
    }
    let outside = json!([{"file_name": "../s.csv", "text": ""}]);
    assert_eq!(new("d.toml", outside).error(422), "bad_input");
}

#[test]
fn what_is_not_there_and_what_is_not_understood_is_said() {
    let served = Served::with(&[("a.toml", CASE), ("b.toml", "[well]\n")]);
    fs::write(served.path().join("b.toml"), b"[well]\n\xff\xfe").unwrap();
    for id in ["0000000000000000", "a.toml", "..%2fa.toml", "%00"] {
        assert_eq!(served.get(&format!("/api/cases/{id}")).error(404), "not_found", "{id}");
    }
    let no_text = served.get(&format!("/api/cases/{}", served.id("b.toml")));
    assert_eq!(no_text.error(500), "failed");
    assert!(no_text.text().contains("it is not a text in UTF-8"));
    assert_eq!(served.get("/api/nothing").error(404), "not_found");
    assert_eq!(served.delete("/api/cases").error(405), "method_not_allowed");
    let path = format!("/api/cases/{}", served.id("a.toml"));
    let unknown = json!({"text": "", "revision": "", "force": true});
    assert_eq!(served.put(&path, &unknown).error(422), "bad_json");
    assert_eq!(served.ask("PUT", &path, "application/json", b"{").error(400), "bad_json");
    assert_eq!(served.ask("PUT", &path, "text/plain", b"{}").error(415), "not_json");
}
