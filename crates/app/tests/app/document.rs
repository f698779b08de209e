//! The description of the API, and what it describes.

use std::{collections::BTreeSet, fs, path::Path};

use crate::common::Served;

/// What is written in the sources: each handler names its path where it is declared.
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
    // What it names is there: no path of it is answered as one that is not.
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
    // Every schema that it refers to is in it.
    let text = document.to_string();
    for name in text.split("#/components/schemas/").skip(1) {
        let name = name.split('"').next().unwrap();
        assert!(document["components"]["schemas"][name].is_object(), "{name}");
    }
}
