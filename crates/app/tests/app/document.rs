//! The description of the API, compared with the sources.

use std::{collections::BTreeSet, fs, path::Path};

use crate::common::Served;

/// The declared paths in the sources: each handler names its path where it is declared.
fn declared(folder: &Path, into: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            declared(&path, into);
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let paths = text.split("path = \"/api/").skip(1);
        into.extend(paths.map(|rest| format!("/api/{}", rest.split('"').next().unwrap())));
    }
}

#[test]
fn the_document_names_every_route() {
    let served = Served::new();
    let document = served.get("/api/openapi.json").ok();
    let named: BTreeSet<String> = document["paths"].as_object().unwrap().keys().cloned().collect();
    let mut in_sources = BTreeSet::new();
    declared(Path::new("src"), &mut in_sources);
    assert!(in_sources.len() > 8);
    assert_eq!(named, in_sources);
    // The named paths exist: none of them is answered as unknown.
    for (path, methods) in document["paths"].as_object().unwrap() {
        let path = path.replace("{id}", "0").replace("{name}", "0");
        for method in methods.as_object().unwrap().keys() {
            if path.ends_with("/events") {
                continue;
            }
            let answer = served.ask(&method.to_uppercase(), &path, "application/json", b"{}");
            assert_ne!(answer.status, 405, "{method} {path}");
            assert!(!answer.text().contains("there is nothing at"), "{method} {path}");
        }
    }
    // Every schema that it refers to is included.
    let text = document.to_string();
    for name in text.split("#/components/schemas/").skip(1) {
        let name = name.split('"').next().unwrap();
        assert!(document["components"]["schemas"][name].is_object(), "{name}");
    }
}

/// Two declared types of one name would overwrite each other in the document.
#[test]
fn every_schema_has_a_name_of_its_own() {
    let mut declared: Vec<String> = Vec::new();
    for folder in ["src", "../screens/src"] {
        names(Path::new(folder), &mut declared);
    }
    assert!(declared.len() > 100);
    let mut once = BTreeSet::new();
    for name in &declared {
        assert!(
            once.insert(name),
            "{name}: give one of its types another with `#[schema(as = ..)]`"
        );
    }
}

/// The names of the declared schemas in the sources.
fn names(folder: &Path, into: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            names(&path, into);
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        // Each declaration begins with its derive; the name is the first word after `struct` or
        // `enum`, unless an attribute gives another.
        for declaration in text.split("#[derive(").skip(1) {
            let Some((derived, rest)) = declaration.split_once(")]") else { continue };
            if !derived.contains("ToSchema") {
                continue;
            }
            let word = |text: &str| {
                text.split(|letter: char| !letter.is_alphanumeric()).next().map(str::to_owned)
            };
            let kinds = ["struct ", "enum "].iter().filter_map(|kind| rest.split_once(kind));
            let Some((attributes, after)) = kinds.min_by_key(|(before, _)| before.len()) else {
                continue;
            };
            let given = attributes.split_once("#[schema(as = ");
            let given = given.and_then(|(_, after)| word(after));
            into.extend(given.or(word(after)));
        }
    }
}
