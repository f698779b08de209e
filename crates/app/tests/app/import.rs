//! Files of other programs, dropped on the page.

use std::{fs, io::Write};

use serde_json::{Value, json};
use zip::{ZipWriter, write::SimpleFileOptions};

use crate::common::{Answer, Served};

/// Sends a form like a browser.
fn send(served: &Served, parts: &[(&str, Option<&str>, &[u8])]) -> Answer {
    let mut body = Vec::new();
    for (name, file, content) in parts {
        let file = file.map_or_else(String::new, |file| format!("; filename=\"{file}\""));
        let head =
            format!("--XyZ\r\nContent-Disposition: form-data; name=\"{name}\"{file}\r\n\r\n");
        body.extend_from_slice(head.as_bytes());
        body.extend_from_slice(content);
        body.extend_from_slice(b"\r\n");
    }
    body.extend_from_slice(b"--XyZ--\r\n");
    served.ask("POST", "/api/import", "multipart/form-data; boundary=XyZ", &body)
}

fn import(served: &Served, files: &[(&str, &str)], choices: &Value, write: Option<&str>) -> Answer {
    let choices = choices.to_string();
    let mut parts = vec![("choices", None, choices.as_bytes())];
    parts.push(("name", None, write.unwrap_or("case.toml").as_bytes()));
    parts.extend(write.map(|_| ("write", None, &b"true"[..])));
    parts.extend(files.iter().map(|(name, text)| ("file", Some(*name), text.as_bytes())));
    send(served, &parts)
}

const WITHOUT_UNIT: &str = "MD,Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n";
const SURVEY: &str = "MD (ft),Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n";

#[test]
fn what_a_file_does_not_tell_is_asked() {
    let served = Served::new();
    let files = [("survey.csv", WITHOUT_UNIT)];
    let answer = import(&served, &files, &json!({}), Some("well.toml")).ok();
    assert_eq!(answer["files"][0]["name"], "survey.csv");
    assert!(answer["files"][0]["what"].as_str().unwrap().contains("survey"), "{answer}");
    let question = &answer["question"];
    assert_eq!((&question["ask"], &question["name"]), (&json!("unit"), &json!("md")));
    let options = question["options"].as_array().unwrap();
    assert!(options.contains(&json!("ft")) && options.contains(&json!("m")), "{options:?}");
    assert!(question["message"].as_str().unwrap().contains("survey.csv"));
    assert_eq!((&answer["case"], &answer["written"]), (&Value::Null, &Value::Null));
    assert!(!served.path().join("well.toml").exists());
    // A wrong answer leads to the same question.
    let wrong = import(&served, &files, &json!({"units": {"md": "kg"}}), None).ok();
    assert_eq!(wrong["question"]["ask"], "unit");

    // With the answer the case is shown, and not written before this is requested.
    let choices = json!({"units": {"md": "ft"}});
    let answer = import(&served, &files, &choices, None).ok();
    let text = answer["case"]["text"].as_str().unwrap();
    assert!(text.contains("[\"1100 ft\", 3, 45]"), "{text}");
    assert_eq!(answer["case"]["missing"].as_array().unwrap().len(), 3);
    assert_eq!(served.get("/api/cases").ok(), json!([]));
    let written = import(&served, &files, &choices, Some("well.toml")).ok();
    assert_eq!(written["written"], served.id("well.toml").as_str());
    assert_eq!(fs::read_to_string(served.path().join("well.toml")).unwrap(), text);
    // Never over an existing file, nor anywhere else.
    assert_eq!(import(&served, &files, &choices, Some("well.toml")).error(409), "conflict");
    for name in ["../well.toml", "/tmp/well.toml", "well", "", "C:\\well.toml"] {
        assert_eq!(import(&served, &files, &choices, Some(name)).error(422), "bad_input", "{name}");
    }
    // An unused choice is reported, not ignored.
    let unused = import(&served, &[("s.csv", SURVEY)], &json!({"units": {"wob": "kN"}}), None).ok();
    assert!(unused["problem"].as_str().unwrap().contains("--unit wob"), "{unused}");
}

#[test]
fn two_files_that_hold_the_same_are_asked_about() {
    let served = Served::new();
    let files = [("a.csv", SURVEY), ("b.csv", SURVEY)];
    let answer = import(&served, &files, &json!({}), None).ok();
    let question = &answer["question"];
    assert_eq!((&question["ask"], &question["name"]), (&json!("pick"), &json!("survey")));
    assert_eq!(question["options"], json!(["a.csv", "b.csv"]));
    let picked = import(&served, &files, &json!({"picks": {"survey": "b.csv"}}), None).ok();
    let notes = picked["case"]["notes"].as_array().unwrap();
    assert!(notes.iter().any(|note| note["file"] == "a.csv" && note["kind"] == "left out"));
}

#[test]
fn what_is_no_form_or_no_file_is_refused() {
    let served = Served::new();
    let plain = served.ask("POST", "/api/import", "text/plain", b"MD,Inc,Azi\n");
    assert_eq!(plain.error(400), "no_form");
    assert_eq!(send(&served, &[("name", None, b"a.toml")]).error(422), "bad_input");
    assert_eq!(send(&served, &[("file", Some("a"), b"x")]).error(422), "bad_input");
    assert_eq!(send(&served, &[("path", None, b"/etc/passwd")]).error(422), "bad_input");
    let wrong = send(&served, &[("choices", None, b"{\"unit\": 1}"), ("file", Some("a"), b"x")]);
    assert_eq!(wrong.error(422), "bad_input");
    let long = vec![b' '; 100_000];
    assert_eq!(send(&served, &[("choices", None, &long)]).error(413), "too_long");
    let half =
        served.ask("POST", "/api/import", "multipart/form-data; boundary=X", b"--X\r\nConte");
    assert_eq!(half.error(400), "bad_form");
    let many: Vec<String> = (0..41).map(|k| format!("{k}.csv")).collect();
    let many: Vec<(&str, Option<&str>, &[u8])> =
        many.iter().map(|name| ("file", Some(name.as_str()), &b"x"[..])).collect();
    let refused = send(&served, &many);
    assert_eq!(refused.error(422), "bad_input");
    assert!(refused.text().contains("more than 40 files"));
    assert_eq!(
        send(&served, &[("file", Some("a"), b"x"), ("file", Some("x/a"), b"y")]).error(422),
        "bad_input"
    );
    let override_name = ("file", Some("log\u{202e}sal.exe"), &b"x"[..]);
    let refused = send(&served, &[("name", None, b"a.toml"), override_name]);
    assert_eq!(refused.error(422), "bad_input");
    assert!(refused.text().contains("U+202E (right-to-left override)"), "{}", refused.text());
    // A file of unknown format is reported as such.
    let name = ("name", None, &b"a.toml"[..]);
    let noise = send(&served, &[name, ("file", Some("a.bin"), &[0, 159, 146, 150])]).ok();
    assert_eq!(noise["files"][0]["what"], Value::Null);
    assert!(noise["problem"].is_string());
    // No temporary file remains.
    let left = fs::read_dir(served.path().join(".wholestring/temporary")).unwrap();
    assert_eq!(left.count(), 0);
}

/// A workbook whose only sheet expands to this many megabytes.
fn bomb(megabytes: usize) -> Vec<u8> {
    let mut zip = ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, head) in [
        ("[Content_Types].xml", "<Types/>"),
        ("xl/workbook.xml", "<workbook><sheets><sheet name=\"a\"/></sheets></workbook>"),
        ("xl/worksheets/sheet1.xml", "<worksheet><sheetData>"),
    ] {
        zip.start_file(name, SimpleFileOptions::default()).unwrap();
        zip.write_all(head.as_bytes()).unwrap();
        if name.contains("sheet1") {
            let zeros = vec![b'0'; 1 << 20];
            (0..megabytes).for_each(|_| zip.write_all(&zeros).unwrap());
        }
    }
    zip.finish().unwrap().into_inner()
}

#[test]
fn bombs_are_refused() {
    let served = Served::new();
    let workbook = bomb(1024);
    // A thousandth of its expanded size.
    assert!(workbook.len() < 2 << 20, "{}", workbook.len());
    let doctype = "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b \"ha\"><!ENTITY c \"&b;&b;\">]>\
        <trajectorys xmlns=\"http://www.witsml.org/schemas/1series\">&c;</trajectorys>";
    let begin = std::time::Instant::now();
    for (name, bytes) in [("a.xlsx", workbook.as_slice()), ("a.xml", doctype.as_bytes())] {
        let case = ("name", None, &b"a.toml"[..]);
        let refused = send(&served, &[case, ("file", Some(name), bytes)]).ok();
        assert_eq!((&refused["case"], &refused["question"]), (&Value::Null, &Value::Null));
        let problem = refused["problem"].as_str().unwrap();
        assert!(problem.starts_with(name), "{problem}");
    }
    // It is not fully expanded, which alone would take longer.
    assert!(begin.elapsed().as_secs() < 20, "{:?}", begin.elapsed());
}

#[test]
fn a_gigabyte_is_refused_before_it_is_taken() {
    let served = Served::new();
    let headers = served.headers();
    let head = format!(
        "POST /api/import HTTP/1.1\r\n{headers}Content-Type: multipart/form-data; boundary=X\r\n\
         Content-Length: {}\r\n\r\n",
        1_u64 << 30
    );
    assert_eq!(served.send(&head, b"--X").error(413), "too_long");
}
