//! What can be looked up: the session, examples, the schema and the catalogue.

use serde_json::json;

use crate::common::Served;

#[test]
fn the_session_names_the_folder_and_no_path() {
    let served = Served::new();
    let session = served.get("/api/session").ok();
    let name = served.path().file_name().unwrap().to_str().unwrap();
    assert_eq!(session, json!({"version": env!("CARGO_PKG_VERSION"), "folder_name": name}));
}

#[test]
fn an_example_becomes_a_sound_case() {
    let served = Served::new();
    let examples = served.get("/api/examples").ok();
    assert!(examples.as_array().unwrap().len() >= 8);
    assert_eq!(examples[0]["name"], "my-well");
    for name in ["my-well", "np13-x1042", "forge-16a"] {
        let example = served.get(&format!("/api/examples/{name}")).ok();
        let new = json!({
            "file_name": format!("{name}.toml"),
            "text": example["text"],
            "beside": example["beside"],
        });
        served.post("/api/cases", &new).ok();
    }
    let cases = served.get("/api/cases").ok();
    let problems = cases.as_array().unwrap().iter().map(|case| case["problem"].clone());
    assert_eq!(problems.collect::<Vec<_>>(), [json!(null), json!(null), json!(null)]);
    assert_eq!(served.get("/api/examples/none").error(404), "not_found");
}

#[test]
fn the_schema_is_that_of_the_case_file() {
    let served = Served::new();
    assert_eq!(served.get("/api/schema").ok(), wholestring_case::schema());
}

#[test]
fn the_catalogue_is_found_by_words() {
    let served = Served::new();
    let found = served.get("/api/catalogue?word=5-1/2%2021.9%20S-135").ok();
    assert_eq!(found["string"][0]["name"], "5-1/2 in 21.90 lb/ft S-135");
    assert_eq!(found["string"][0]["kind"], "drill_pipe");
    let od_m = found["string"][0]["od_m"].as_f64().unwrap();
    assert!((od_m - 0.1397).abs() < 1e-9);
    assert!(!found["sources"].as_array().unwrap().is_empty());
    let all = served.get("/api/catalogue").ok();
    for kind in ["string", "casings", "top_drives", "hoists"] {
        assert!(!all[kind].as_array().unwrap().is_empty(), "{kind}");
    }
    assert_eq!(served.get("/api/catalogue?word=zzz").ok()["string"], json!([]));
}
