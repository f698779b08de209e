//! Reference data: the session, examples, the schema and the catalogue.

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
    assert_eq!(examples.as_array().unwrap().len(), 1 + wholestring_cases::ALL.len());
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

#[test]
fn units_are_known_by_dimension() {
    let served = Served::new();
    let units = served.get("/api/units").ok();
    let diameter = &units["diameter"];
    assert_eq!(diameter["factors"]["in"], 0.0254);
    assert_eq!(
        diameter["shown"]["field"],
        json!({"symbol": "in", "label": "in", "factor": 0.0254})
    );
    assert_eq!(diameter["shown"]["si"]["symbol"], "mm");
    assert_eq!(units["angle"]["shown"]["si"]["label"], "°");
    assert_eq!(units["percent"]["shown"]["si"]["symbol"], json!(null));
    // Every unit that the schema names for a bare number is known.
    fn bare(schema: &serde_json::Value, units: &serde_json::Value, found: &mut usize) {
        if let Some(name) = schema["x-dimension"].as_str() {
            let unit = schema["anyOf"][0]["x-unit"].as_str().unwrap();
            assert!(units[name]["factors"][unit].is_number(), "{unit} of {name}");
            *found += 1;
        }
        let all = schema.as_object().into_iter().flat_map(|members| members.values());
        all.chain(schema.as_array().into_iter().flatten())
            .for_each(|member| bare(member, units, found));
    }
    let mut found = 0;
    bare(&served.get("/api/schema").ok(), &units, &mut found);
    assert!(found > 100, "{found}");
}

#[test]
fn rows_of_a_spreadsheet_are_a_survey() {
    let served = Served::new();
    let read = |text: &str, unit: serde_json::Value| {
        served.post("/api/survey", &json!({"text": text, "length_unit": unit}))
    };
    let rows = "MD (ft)\tInc (deg)\tAzi (deg)\n0\t0\t0\n1000\t0\t0\n1100\t3\t45\n";
    let survey = read(rows, json!(null)).ok();
    let md_m = survey["stations"]["md_m"].as_array().unwrap();
    assert!((md_m[1].as_f64().unwrap() - 304.8).abs() < 1e-9);
    let dogleg = survey["stations"]["dogleg_severity_rad_per_m"][2].as_f64().unwrap();
    assert!((dogleg - 3_f64.to_radians() / 30.48).abs() < 1e-12);
    // Without any unit of length it is refused, until one is given.
    let bare = "MD,Inc,Azi\n0,0,0\n1000,0,0\n";
    assert_eq!(read(bare, json!(null)).error(422), "bad_input");
    assert_eq!(read(bare, json!("m")).ok()["stations"]["md_m"][1], 1000.0);
    assert_eq!(read(bare, json!("bar")).error(422), "bad_input");
    assert_eq!(read("nothing", json!(null)).error(422), "bad_input");
}
