//! Contents of the results folder, and how they are served.

use std::fs;

use serde_json::{Value, json};

use crate::common::{Served, link::symlink};

const PAGE: &str = "<!doctype html><meta name=\"generator\" content=\"wholestring 9.9.9\">";

/// A results folder made by hand.
fn put(served: &Served, folder: &str, friction: f64, hook_load: f64) {
    let path = served.path().join(folder);
    fs::create_dir_all(path.join("plots")).unwrap();
    let finding = json!({"kind": "helical_buckling", "level": "error", "message": "Buckled."});
    let summary = json!({"case": "slant", "settings": {"mud": {"density_kg_per_m3": 1200.0},
        "friction": friction}, "state": {"hook_load_N": hook_load},
        "operations": [{"operation": "slide", "model": "soft", "findings": [finding]}]});
    fs::write(path.join("summary.json"), summary.to_string()).unwrap();
    fs::write(path.join("report.html"), PAGE).unwrap();
    fs::write(path.join("plots/a b.svg"), "<svg/>").unwrap();
    fs::write(path.join(".wholestring"), r#"{"kind":"assembly","name":"x","identity":"1"}"#)
        .unwrap();
}

fn id_of(list: &Value, path: &str) -> String {
    let found = list.as_array().unwrap().iter().find(|file| file["path"] == path);
    found.unwrap_or_else(|| panic!("{path}: {list}"))["id"].as_str().unwrap().to_owned()
}

#[test]
fn results_are_listed_with_their_files() {
    let served = Served::new();
    put(&served, "out/one", 0.2, 1.0);
    put(&served, "wells/out/two", 0.3, 2.0);
    let list = served.get("/api/results").ok();
    let entry = &list[0];
    assert_eq!((&entry["path"], &entry["kind"]), (&json!("out/one"), &json!("assembly")));
    assert_eq!((&entry["name"], &entry["engine_version"]), (&json!("slant"), &json!("9.9.9")));
    assert_eq!((&entry["errors"], &entry["warnings"]), (&json!(1), &json!(0)));
    assert!(entry["modified_ms"].as_u64().unwrap() > 1_600_000_000_000);
    assert_eq!(list.as_array().unwrap().len(), 2);
    let results = served.get(&format!("/api/results/{}", id_of(&list, "out/one"))).ok();
    assert_eq!(results["checks"][0]["sentence"], "Buckled.");
    assert_eq!(results["checks"][0]["name"], "slide (soft)");
    let paths: Vec<&str> = results["files"]
        .as_array()
        .unwrap()
        .iter()
        .map(|file| file["path"].as_str().unwrap())
        .collect();
    assert_eq!(paths, ["plots/a b.svg", "report.html", "summary.json"]);

    let file = |path: &str| {
        let (id, file) = (id_of(&list, "out/one"), id_of(&results["files"], path));
        served.get(&format!("/api/results/{id}/files/{file}"))
    };
    let picture = file("plots/a b.svg");
    assert_eq!((picture.status, picture.text().as_str()), (200, "<svg/>"));
    assert_eq!(
        picture.header("content-disposition"),
        Some("attachment; filename*=UTF-8''a%20b.svg")
    );
    // Opened directly, it is allowed nothing.
    let policy = picture.header("content-security-policy").unwrap();
    assert_eq!(policy, "sandbox; default-src 'none'; frame-ancestors 'none'");
    assert_eq!(file("summary.json").status, 200);
}

#[test]
fn a_page_is_shut_in() {
    let served = Served::new();
    put(&served, "out/one", 0.2, 1.0);
    let list = served.get("/api/results").ok();
    let id = id_of(&list, "out/one");
    let files = served.get(&format!("/api/results/{id}")).ok()["files"].clone();
    let page = served.get(&format!("/api/results/{id}/pages/{}", id_of(&files, "report.html")));
    assert!(page.text().starts_with(PAGE));
    assert_eq!(page.header("content-type"), Some("text/html; charset=utf-8"));
    let policy = page.header("content-security-policy").unwrap();
    assert!(policy.starts_with("sandbox allow-scripts allow-downloads allow-modals; "), "{policy}");
    assert!(policy.contains("default-src 'none'") && policy.contains("frame-ancestors 'self'"));
    assert!(!policy.contains("allow-same-origin") && !policy.contains("connect-src"));
    // A browser marks requests of a frame without an origin like this.
    let host = served.host();
    let cookie = format!("Cookie: {}\r\n", served.cookie);
    for marks in ["Origin: null\r\n", "Sec-Fetch-Site: cross-site\r\n"] {
        let head = format!(
            "POST /api/cases HTTP/1.1\r\nHost: {host}\r\n{cookie}{marks}Content-Length: 2\r\n\
             Content-Type: application/json\r\nConnection: close\r\n\r\n"
        );
        assert_eq!(served.send(&head, b"{}").error(403), "foreign_origin");
    }
    let head = format!(
        "GET /api/cases HTTP/1.1\r\nHost: {host}\r\n{cookie}Sec-Fetch-Site: cross-site\r\n\
         Connection: close\r\n\r\n"
    );
    assert_eq!(served.send(&head, b"").error(403), "foreign_origin");
    // Other files are no pages.
    let other = id_of(&files, "summary.json");
    assert_eq!(served.get(&format!("/api/results/{id}/pages/{other}")).error(404), "not_found");
}

#[test]
fn ids_are_no_paths_and_links_are_not_followed() {
    let elsewhere = tempfile::tempdir().unwrap();
    fs::write(elsewhere.path().join("summary.json"), "{}").unwrap();
    fs::write(elsewhere.path().join("secret.txt"), "secret").unwrap();
    let served = Served::with(&[("a.toml", "secret")]);
    put(&served, "out/one", 0.2, 1.0);
    let folder = served.path().join("out");
    symlink(elsewhere.path(), folder.join("two")).unwrap();
    symlink(elsewhere.path().join("secret.txt"), folder.join("one/secret.txt")).unwrap();
    symlink(elsewhere.path(), folder.join("one/plots/out")).unwrap();
    let list = served.get("/api/results").ok();
    assert_eq!(list.as_array().unwrap().len(), 1);
    let id = id_of(&list, "out/one");
    let files = served.get(&format!("/api/results/{id}")).ok()["files"].clone();
    assert!(!files.to_string().contains("secret"), "{files}");
    let page = id_of(&files, "report.html");
    for (id, file) in [
        ("out%2fone", page.as_str()),
        ("..%2f..%2fetc", page.as_str()),
        (&id, "report.html"),
        (&id, "..%2f..%2fa.toml"),
        (&id, "..%2f..%2f..%2f..%2f..%2fetc%2fpasswd"),
        (&id, "%2fetc%2fpasswd"),
        (&id, "%5c%5cserver%5cshare"),
        (&id, "secret.txt"),
    ] {
        for noun in ["files", "pages"] {
            let answer = served.get(&format!("/api/results/{id}/{noun}/{file}"));
            assert_eq!(answer.error(404), "not_found", "{id} {file}");
        }
    }
    let plain = served.get(&format!("/api/results/{id}/files/../../a.toml"));
    assert_eq!(plain.status, 404);
}

#[test]
fn results_stand_side_by_side() {
    let served = Served::new();
    put(&served, "out/one", 0.2, 100.0);
    put(&served, "out/two", 0.3, 200.0);
    let list = served.get("/api/results").ok();
    let ids = format!("{},{}", id_of(&list, "out/one"), id_of(&list, "out/two"));
    let compared = served.get(&format!("/api/compare?ids={ids}&units=metric")).ok();
    assert_eq!(compared["inputs"], json!([{"key": "friction", "values": ["0.2", "0.3"]}]));
    assert_eq!(
        compared["scalars"],
        json!([{"of": "state", "label": "hook_load_N", "unit": "", "values": [100.0, 200.0]}])
    );
    assert_eq!(compared["results"][1]["path"], "out/two");
    let one = id_of(&list, "out/one");
    for (query, status) in [
        (format!("ids={one}"), 422),
        (format!("ids={}", [one.as_str(); 7].join(",")), 422),
        (format!("ids={one},{one}&units=imperial"), 422),
        (format!("ids={one},out%2ftwo"), 404),
    ] {
        assert_eq!(served.get(&format!("/api/compare?{query}")).status, status, "{query}");
    }
}
