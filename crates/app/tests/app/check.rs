//! Diagnostics of a text that is not saved yet.

use serde_json::{Value, json};

use crate::common::{CASE, Served};

fn check(served: &Served, text: &str) -> Value {
    let path = format!("/api/cases/{}/check", served.id("a.toml"));
    served.post(&path, &json!({"text": text})).ok()
}

#[test]
fn a_mistake_is_said_with_its_key_and_place() {
    let served = Served::with(&[("a.toml", CASE)]);
    let sound = check(&served, CASE);
    assert_eq!(sound["diagnostics"], json!([]));
    assert_eq!(sound["values"]["well"]["hole"][0]["friction"], 0.3);
    assert_eq!(sound["values"]["mud"]["density"], "1.2 sg");
    assert_eq!(sound["values"]["name"], "slant");

    let text = CASE.replace("A slant", "𝄞 A slant").replace("1.2 sg", "1.2 bar");
    let answer = check(&served, &text);
    let [one] = answer["diagnostics"].as_array().unwrap().as_slice() else { panic!("{answer}") };
    assert_eq!(one["level"], "error");
    assert_eq!(one["message"], "`bar` is a unit of pressure, not of density");
    assert_eq!((&one["key"], &one["file"]), (&json!("mud.density"), &Value::Null));
    assert_eq!((&one["line"], &one["column"]), (&json!(14), &json!(16)));
    let units: Vec<u16> = text.encode_utf16().collect();
    let place = |key: &str| usize::try_from(one[key].as_u64().unwrap()).unwrap();
    assert_eq!(String::from_utf16_lossy(&units[place("start")..place("end")]), "bar");
    assert!(one["help"][0].as_str().unwrap().starts_with("units of density"));
    assert_eq!(answer["values"]["mud"]["density"], "1.2 bar");
}

#[test]
fn what_is_no_toml_has_no_values() {
    let served = Served::with(&[("a.toml", CASE)]);
    let answer = check(&served, "[well]\nsurvey = \n");
    assert_eq!(answer["values"], Value::Null);
    assert_eq!(answer["diagnostics"][0]["message"], "a value is missing after `=`");
    assert_eq!(answer["diagnostics"][0]["line"], 2);
    assert_eq!(check(&served, "")["diagnostics"][0]["message"], "the case file is empty");
}

#[test]
fn warnings_and_notes_are_said_too() {
    let stations =
        "stations = [[\"0 m\", \"0 deg\", \"0 deg\"], [\"1000 m\", \"30 deg\", \"0 deg\"]]";
    let case = CASE.replace(stations, "survey = \"s.csv\"");
    assert_ne!(case, CASE);
    let survey = "md (m),inc (deg),azi (deg)\n0,0,0\n1000,30,0\n";
    let served = Served::with(&[("a.toml", &case), ("s.csv", survey)]);
    let answer = check(&served, &case.replace("friction = 0.3", "friction = 0.02"));
    let [warning, note, ..] = answer["diagnostics"].as_array().unwrap().as_slice() else {
        panic!("{answer}")
    };
    assert_eq!(
        (&warning["level"], &warning["key"]),
        (&json!("warning"), &json!("well.hole.0.friction"))
    );
    assert_eq!((&note["level"], &note["key"]), (&json!("note"), &json!("well.survey")));
    assert!(note["message"].as_str().unwrap().contains("commas"), "{note}");
    // A mistake in the survey is located in the survey, at the key that names it.
    let bad = Served::with(&[
        ("a.toml", &case),
        ("s.csv", "md (m),inc (deg),azi (deg)\n0,0,0\n1000,x,0\n"),
    ]);
    let answer = check(&bad, &case);
    assert_eq!(answer["diagnostics"][0]["file"], "s.csv", "{answer}");
    assert_eq!(answer["diagnostics"][0]["key"], "well.survey", "{answer}");
    assert_eq!(answer["diagnostics"][0]["line"], 3, "{answer}");
}

#[test]
fn what_can_be_drawn_is_there_though_the_rest_is_not_sound() {
    let served = Served::with(&[("a.toml", CASE)]);
    let arc = CASE.replace("[well]", "[well]\npath = \"minimum-curvature\"");
    let answer = check(&served, &arc.replace("1.2 sg", "1.2 bar"));
    assert_eq!(answer["diagnostics"][0]["level"], "error");
    let stations = &answer["layout"]["stations"];
    assert_eq!(stations["md_m"], json!([0.0, 1000.0]));
    let dogleg = stations["dogleg_severity_rad_per_m"][1].as_f64().unwrap();
    // 30 deg in 1000 m.
    assert!((dogleg - 30_f64.to_radians() / 1000.0).abs() < 1e-15);
    let path = &answer["layout"]["path"];
    // A single arc of radius L/angle; columns are sent in single precision.
    let last = path["md_m"].as_array().unwrap().len() - 1;
    let radius_m = 1000.0 / 30_f64.to_radians();
    let tvd_m = path["tvd_m"][last].as_f64().unwrap();
    assert!((tvd_m - radius_m * 30_f64.to_radians().sin()).abs() < 1e-4, "{tvd_m}");
    assert_eq!(answer["layout"]["hole"][0]["to_m"], 1000.0);
    let pipe = &answer["layout"]["string"][0];
    assert_eq!((&pipe["name"], &pipe["to_m"]), (&json!("drill pipe"), &json!(1000.0)));
    let nothing = check(&served, "[well");
    assert_eq!(nothing["layout"]["path"], Value::Null);
    assert_eq!(nothing["layout"]["stations"]["md_m"], json!([]));
}

#[test]
fn texts_are_told_in_si() {
    let served = Served::with(&[("a.toml", CASE)]);
    let text = CASE.replace("\"1000 m\", \"30 deg\"", "\"3280.84 ft\", \"30 degrees\"");
    let quantities = &check(&served, &text)["quantities"];
    let hole_m = quantities["diameter"]["8-1/2 in"].as_f64().unwrap();
    assert!((hole_m - 0.2159).abs() < 1e-12);
    let length_m = quantities["length"]["3280.84 ft"].as_f64().unwrap();
    assert!((length_m - 1_000.000_032).abs() < 1e-6);
    assert_eq!(quantities["density"]["1.2 sg"], 1200.0);
    assert_eq!(quantities["angle"]["0 deg"], 0.0);
    // No quantity, no number; and a text that is no quantity of its key gives none.
    assert_eq!(quantities["length"]["to surface"], Value::Null);
    let wrong = check(&served, &CASE.replace("1.2 sg", "1.2 bar"));
    assert_eq!(wrong["quantities"]["density"], Value::Null);
}
