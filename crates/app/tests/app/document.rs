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
