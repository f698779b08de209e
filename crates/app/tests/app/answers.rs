//! Live answers while a text is edited.

use serde_json::json;

use crate::common::{CASE, Served};

#[test]
fn a_text_is_answered_by_both_models_and_written_nowhere() {
    let served = Served::with(&[("slant.toml", CASE)]);
    let id = served.id("slant.toml");
    let request = json!({"text": CASE, "set": {"friction": "0.2"}});
    let answer = served.post(&format!("/api/cases/{id}/answer"), &request).ok();
    let operations = answer["operations"].as_array().unwrap();
    let models: Vec<&str> = operations.iter().map(|one| one["model"].as_str().unwrap()).collect();
    assert_eq!(models, ["soft", "stiff"]);
    // The case's own friction gives a larger pull.
    let own = served.post(&format!("/api/cases/{id}/answer"), &json!({"text": CASE})).ok();
    let hook_load =
        |answer: &serde_json::Value| answer["operations"][0]["hook_load_N"].as_f64().unwrap();
    assert!(hook_load(&own) > hook_load(&answer) + 1e3);
    assert_eq!(answer["well"]["string"][0]["to_m"], 1000.0);
    // The initial values of the page's sliders follow the text and its replacements.
    let friction = |answer: &serde_json::Value| answer["set_points"]["values"][1].clone();
    assert_eq!(
        (friction(&own)["key"].as_str(), friction(&own)["now"].as_f64()),
        (Some("friction"), Some(0.3))
    );
    assert_eq!(friction(&answer)["now"], 0.2);
    assert_eq!(own["set_points"]["sections"][0]["label"], "open hole to 1000 m");
    // Sentences are in the requested units.
    let hoisted = CASE.replace("[operation]", "[rig]\nhoist_capacity = \"1500 kN\"\n\n[operation]");
    let field = json!({"text": hoisted, "models": ["soft"], "units": "field"});
    let field = served.post(&format!("/api/cases/{id}/answer"), &field).ok();
    let sentence = field["limits"][0]["limits"][0]["sentence"].as_str().unwrap();
    assert!(sentence.contains(" klbf") && !sentence.contains(" kN"), "{sentence}");
    assert_eq!(field["set_points"]["units"], "si");
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
    let request = json!({"text": CASE});
    let found = served.post(&format!("/api/cases/{id}/broomstick"), &request).ok();
    let curves = found["curves"].as_array().unwrap();
    let pulled = curves.iter().filter(|one| one["operation"] == "trip_out");
    let frictions: Vec<&str> = pulled.map(|one| one["friction"].as_str().unwrap()).collect();
    assert_eq!(frictions, ["low", "expected", "high"]);
}

#[test]
fn limits_are_those_of_the_operation() {
    let served = Served::with(&[("slant.toml", CASE)]);
    let id = served.id("slant.toml");
    let path = format!("/api/cases/{id}/answer");
    let text = format!("{CASE}\n[rig]\nhoist_capacity = \"200 kN\"\n");
    let found = served.post(&path, &json!({"text": text})).ok();
    let all = found["limits"][0]["limits"].as_array().unwrap();
    let hoist = all.iter().find(|one| one["kind"] == "hoist").unwrap();
    let load_N = hoist["load"].as_f64().unwrap();
    assert_eq!(found["limits"][0]["operation"], "trip_out");
    let hook_load_N = found["operations"][0]["hook_load_N"].as_f64().unwrap();
    assert!((load_N / hook_load_N - 1.0).abs() < 1e-9, "{load_N} {hook_load_N}");
    assert_eq!(
        (hoist["capacity"].as_f64(), hoist["dimension"].as_str()),
        (Some(200e3), Some("force"))
    );
    // The stiff string alone has no limits.
    let stiff = served.post(&path, &json!({"text": text, "models": ["stiff"]})).ok();
    assert_eq!(stiff["limits"], json!([]));
    let broomstick = format!("/api/cases/{id}/broomstick");
    let found = served.post(&broomstick, &json!({"text": text})).ok();
    assert_eq!(found["hoist_N"], 200e3);
    assert_eq!(found["frictions"][1], json!({"name": "expected", "coefficients": [0.3]}));
}

#[test]
fn an_assembly_lies_in_its_hole() {
    let served = Served::with(&[("slant.toml", CASE)]);
    let path = format!("/api/cases/{}/assembly", served.id("slant.toml"));
    let found = served.post(&path, &json!({"text": CASE})).ok();
    assert_eq!(found["operation"], "trip_out");
    let axis = &found["axis"];
    let numbers = |name: &str| -> Vec<f64> {
        axis[name].as_array().unwrap().iter().map(|one| one.as_f64().unwrap()).collect()
    };
    let (high, right) = (numbers("offset_high_m"), numbers("offset_right_m"));
    // At most half of hole minus string from the middle, for a pipe in 8-1/2 in.
    let room_m = 0.5 * (8.5 * 0.0254 - 0.127);
    // Single precision, and a wall that yields slightly.
    let reach = high.iter().zip(&right).map(|(high, right)| high.hypot(*right));
    assert!(reach.fold(0.0, f64::max) < room_m + 1e-3);
    // In a hole inclined by 30 deg a string lies on its low side.
    assert!(high.iter().copied().fold(0.0, f64::min) < -0.9 * room_m, "{high:?}");
    assert!(!found["contacts"].as_array().unwrap().is_empty());
    let request = json!({"text": CASE, "operation": "drill"});
    let refused = served.post(&path, &request);
    assert_eq!(refused.error(422), "bad_input");
    assert!(refused.text().contains("it has trip_out"), "{}", refused.text());
    let request = json!({"text": CASE, "operation": "swim"});
    assert_eq!(served.post(&path, &request).error(422), "bad_input");
    // The choice of models for an answer is invalid here.
    let request = json!({"text": CASE, "models": ["soft"]});
    assert_eq!(served.post(&path, &request).error(422), "bad_json");
}

#[test]
fn every_dimension_has_units() {
    let served = Served::new();
    let units = served.get("/api/units").ok();
    assert_eq!(units["force"]["shown"]["field"]["symbol"], "klbf");
    assert_eq!(
        units["force"]["shown"]["si"],
        json!({"symbol": "kN", "label": "kN", "factor": 1000.0})
    );
    assert_eq!(units["dogleg severity"]["shown"]["si"]["label"], "°/30 m");
}
