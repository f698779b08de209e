//! The documented list of keys is the program's.

use std::{env, fmt::Write as _, fs, path::Path};

use serde_json::Value;

const BEGIN: &str = "<!-- keys, from the schema -->\n";
const END: &str = "<!-- end of keys -->\n";

/// Set this to rewrite the page.
const UPDATE: &str = "WHOLESTRING_UPDATE_DOCS";

/// A heading and a table of keys for this table of the case file and those below it, once if it
/// occurs at several places.
fn describe(schema: &Value, text: &mut String) {
    let (Some(title), Some(keys)) = (schema["title"].as_str(), schema["properties"].as_object())
    else {
        return;
    };
    let required = |key: &str| {
        let required = schema["required"].as_array();
        required.is_some_and(|all| all.iter().any(|name| name == key))
    };
    let mut section = format!("\n### {title}\n\n| key | meaning |\n|---|---|\n");
    for (key, value) in keys {
        let meaning = value["description"].as_str().unwrap_or("").replace('|', "\\|");
        let needed = if required(key) { " Required." } else { "" };
        let _ = writeln!(section, "| `{key}` | {}{needed} |", meaning.replace('\n', " "));
    }
    if !text.contains(&section) {
        *text += &section;
    }
    for value in keys.values() {
        describe(value, text);
        describe(&value["items"], text);
        let choices = value["anyOf"].as_array();
        choices.into_iter().flatten().for_each(|choice| describe(choice, text));
    }
}

/// Compares the keys on a page with the schema, or rewrites them.
fn list(page: &str, schema: &Value) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src").join(page);
    let text = fs::read_to_string(&path).unwrap().replace("\r\n", "\n");
    let (before, rest) = text.split_once(BEGIN).expect("the page marks where keys begin");
    let (found, after) = rest.split_once(END).expect("the page marks where keys end");
    let mut expected = String::new();
    describe(schema, &mut expected);
    expected.push('\n');
    if env::var_os(UPDATE).is_some() {
        fs::write(&path, format!("{before}{BEGIN}{expected}{END}{after}")).unwrap();
    } else {
        assert!(
            found == expected,
            "docs/src/{page} does not list the keys of the schema; run this test with {UPDATE}=1 \
             to rewrite it"
        );
    }
}

#[test]
fn the_pages_list_every_key() {
    list("case-file.md", &wholestring_case::schema());
    list("catalogue.md", &wholestring_case::catalogue_schema());
    list("study.md", &wholestring_study::schema());
}
