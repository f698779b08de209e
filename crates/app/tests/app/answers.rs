//! Answers as one types.

use serde_json::json;

use crate::common::{CASE, Served};

#[test]
fn a_text_is_answered_by_both_models_and_written_nowhere() {
    let served = Served::with(&[("slant.toml", CASE)]);
    let id = served.id("slant.toml");
    let asked = json!({"text": CASE, "set": {"friction": "0.2"}});
    let answer = served.post(&format!("/api/cases/{id}/answer"), &asked).ok();
    let operations = answer["operations"].as_array().unwrap();
    let models: Vec<&str> = operations.iter().map(|one| one["model"].as_str().unwrap()).collect();
    assert_eq!(models, ["soft", "stiff"]);
    // With the case's own friction it is harder to pull.
    let own = served.post(&format!("/api/cases/{id}/answer"), &json!({"text": CASE})).ok();
    let hook_load = |of: &serde_json::Value| of["operations"][0]["hook_load_N"].as_f64().unwrap();
    assert!(hook_load(&own) > hook_load(&answer) + 1e3);
    assert_eq!(answer["well"]["string"][0]["to_m"], 1000.0);
    let rows = answer["tracks"][0]["md_m"].as_array().unwrap().len();
    assert_eq!(answer["tracks"][0]["tension_N"].as_array().unwrap().len(), rows);
    assert_eq!(std::fs::read_dir(served.path()).unwrap().count(), 1);
}

#[test]
fn what_cannot_be_answered_is_said() {
    let served = Served::with(&[("slant.toml", CASE)]);
    let id = served.id("slant.toml");
    let path = format!("/api/cases/{id}/answer");
    let broken = json!({"text": CASE.replace("0.3", "\"much\"")});
    let refused = served.post(&path, &broken);
    assert_eq!(refused.error(422), "unsound");
    assert_eq!(refused.json()["error"]["diagnostics"][0]["key"], "well.hole.0.friction");
    let dynamic = json!({"text": CASE, "models": ["dynamic"]});
    assert_eq!(served.post(&path, &dynamic).error(422), "bad_input");
    let no_key = json!({"text": CASE, "set": {"": "1"}});
    assert_eq!(served.post(&path, &no_key).error(422), "bad_input");
    let other = json!({"text": CASE, "sets": {}});
    assert_eq!(served.post(&path, &other).error(422), "bad_json");
    assert_eq!(served.post("/api/cases/0/answer", &json!({"text": CASE})).error(404), "not_found");
}

#[test]
fn a_broomstick_has_three_frictions() {
    let served = Served::with(&[("slant.toml", CASE)]);
    let id = served.id("slant.toml");
    let asked = json!({"text": CASE});
    let found = served.post(&format!("/api/cases/{id}/broomstick"), &asked).ok();
    let curves = found["curves"].as_array().unwrap();
    let pulled = curves.iter().filter(|one| one["operation"] == "trip_out");
    let frictions: Vec<&str> = pulled.map(|one| one["friction"].as_str().unwrap()).collect();
    assert_eq!(frictions, ["low", "expected", "high"]);
}
