//! The schema agrees with the reader.

mod common;

use common::{EXAMPLE, SURVEY, changed, read, schema_check::problems, survey_files};
use serde_json::Value as Json;
use wholestring_case::{parse, schema};

#[test]
fn is_on_record() {
    insta::assert_snapshot!(serde_json::to_string_pretty(&schema()).expect("JSON"));
}

#[test]
fn accepts_the_documented_example() {
    assert_eq!(problems(&schema(), EXAMPLE), Vec::<String>::new());
}

#[test]
fn accepts_every_shipped_case() {
    let schema = schema();
    for case in wholestring_cases::ALL {
        assert_eq!(problems(&schema, case.text), Vec::<String>::new(), "{}", case.file_name);
    }
}

/// Wherever the reader rejects a key, the schema does too, and vice versa.
#[test]
fn refuses_a_misspelt_key_in_every_table() {
    let schema = schema();
    for heading in
        ["[well]", "[mud]", "[steel]", "[bit]", "[rig]", "[operation]", "[mesh]", "[dynamics]"]
    {
        let text = EXAMPLE.replacen(heading, &format!("{heading}\nno_such_key = 1 #"), 1);
        assert!(!problems(&schema, &text).is_empty(), "{heading}");
        assert!(read(&text).is_err(), "{heading}");
    }
    for heading in ["[[well.hole]]", "[[string]]"] {
        let text = EXAMPLE.replacen(heading, &format!("{heading}\nno_such_key = 1"), 1);
        assert!(!problems(&schema, &text).is_empty(), "{heading}");
        assert!(read(&text).is_err(), "{heading}");
    }
}

#[test]
fn refuses_what_the_reader_refuses_for_its_form() {
    let schema = schema();
    for (from, to) in [
        ("\"1.2 sg\"", "\"heavy\""),
        ("\"1.2 sg\"", "-1"),
        ("\"1.2 sg\"", "nan"),
        ("\"1.2 sg\"", "1e308"),
        ("\"1.2 sg\"", "[1.2]"),
        ("density = \"1.2 sg\"", ""),
        ("kind = \"open\"", "kind = \"openhole\""),
        ("kind = \"drill\"", "kind = []"),
        ("kind = \"drill\"", "kind = \"cement\""),
        ("model = \"dynamic\"", "model = \"rigid\""),
        ("seed = 1", "seed = 1.5"),
        ("seed = 1", "seed = -1"),
        ("\"to surface\"", "\"to the surface\""),
        ("friction = 0.3\n[[", "friction = \"0.3\"\n[["),
        ("friction = 0.3\n[[", "friction = { static = 0.3 }\n[["),
        ("friction = 0.3\n[[", "friction = 2.5\n[["),
        ("rpm = 70 ", "rpm = 1001 "),
        ("name = \"NP13-X1042 at total depth\"", "name = \"\""),
    ] {
        let text = changed(from, to);
        assert!(!problems(&schema, &text).is_empty(), "the schema accepts {to}");
        assert!(read(&text).is_err(), "the reader accepts {to}");
    }
}

/// Every default of the schema is accepted when the file states it.
#[test]
fn states_defaults_that_the_reader_accepts() {
    let schema = schema();
    let tables = schema["properties"].as_object().expect("keys");
    let mut tried = 0;
    for (table, rule) in tables {
        let Some(keys) = rule["properties"].as_object() else {
            continue;
        };
        for (key, rule) in keys {
            let Some(default) = rule.get("default") else {
                continue;
            };
            let heading = format!("[{table}]");
            let line = format!("{key} = {default}");
            // A bit test needs a rock.
            let needs = match table.as_str() {
                "bit_test" => "[rock]\nstrength = \"60 MPa\"\n[bit_test]\n",
                _ => "",
            };
            let plain = without(&heading, key) + needs;
            let mut text = plain.clone();
            if text.contains(&heading) {
                text = text.replacen(&heading, &format!("{heading}\n{line} #"), 1);
            } else {
                text.push_str(&format!("{heading}\n{line}\n"));
            }
            let answer = parse("case.toml", text.as_bytes(), &survey_files(SURVEY.as_bytes()), &[]);
            let case = answer.unwrap_or_else(|report| panic!("{table}.{key}: {report}"));
            let plain = read(&plain).expect("the example without the key");
            assert_eq!(case.settings, plain.settings, "{table}.{key} = {default}");
            tried += 1;
        }
    }
    assert!(tried > 20, "only {tried} defaults");
}

/// The example without a key of one of its tables.
fn without(heading: &str, key: &str) -> String {
    let mut inside = false;
    let mut text = String::new();
    for line in EXAMPLE.lines() {
        if line.starts_with('[') {
            inside = line.starts_with(heading);
        }
        if !(inside && line.starts_with(&format!("{key} ="))) {
            text.push_str(line);
            text.push('\n');
        }
    }
    text
}

/// Every key has a description.
#[test]
fn describes_every_key() {
    fn visit(schema: &Json, at: &str) {
        let Some(keys) = schema["properties"].as_object() else {
            return;
        };
        for (key, rule) in keys {
            let text = rule["description"].as_str().unwrap_or_default();
            assert!(text.len() > 8 && text.ends_with(['.', ')']), "{at}.{key}: {text:?}");
            assert!(!text.contains("  "), "{at}.{key}: {text:?}");
            visit(rule, &format!("{at}.{key}"));
            visit(&rule["items"], &format!("{at}.{key}"));
        }
    }
    visit(&schema(), "case");
}

/// Every quantity has usual numbers, or is listed here with the reason why it has none.
#[test]
fn quantities_have_usual_numbers() {
    const NONE: &[(&str, &str)] = &[
        ("tie_in", "coordinates of any origin"),
        ("stations", "rows of three, read one by one"),
        ("bend_at", "a place on the component, which bounds it"),
        ("bend_toolface", "any angle"),
        ("lateral_force_at", "a place on the component, which bounds it"),
        ("lateral_force_toolface", "any angle"),
        ("eccentricity_phase", "any angle"),
        ("face", "lengths that the bit's diameter bounds"),
        ("rock", "angles, energies and margins that the rock bounds"),
        ("hoist", "gains and speeds of controllers, of either sign"),
        ("schedule", "times, and quantities that start and end at rest"),
        ("dynamics", "times and numbers of the method"),
        ("bit_test", "times, and speeds down to one revolution in a minute"),
        ("modes", "speeds from rest on, and a place on the string, which bounds it"),
        ("records", "times and depths that the run bounds"),
        ("points", "rows of a table"),
        ("table", "rows of a table"),
        ("from", "checked against the section above"),
    ];
    fn visit(schema: &Json, path: &str, lacking: &mut Vec<String>) {
        match schema {
            Json::Object(object) => {
                let quantity = object.get("anyOf").and_then(Json::as_array);
                let number = quantity.and_then(|forms| {
                    let text = forms.iter().any(|form| form.get("pattern").is_some());
                    let number = forms.iter().find(|form| form["type"] == "number");
                    number.filter(|_| text)
                });
                if let Some(number) = number
                    && number.get("x-usual").is_none()
                {
                    lacking.push(path.to_owned());
                }
                for (key, value) in object {
                    let skipped = ["properties", "items", "anyOf"].contains(&key.as_str());
                    let inner = if skipped { path.to_owned() } else { format!("{path}.{key}") };
                    visit(value, &inner, lacking);
                }
            }
            Json::Array(items) => items.iter().for_each(|item| visit(item, path, lacking)),
            _ => {}
        }
    }
    let mut lacking = Vec::new();
    visit(&schema(), "", &mut lacking);
    lacking.retain(|path| !NONE.iter().any(|(key, _)| path.split('.').any(|part| part == *key)));
    assert_eq!(lacking, Vec::<String>::new());
}
