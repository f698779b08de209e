//! Damaged files: a message with the file's name, exit status 2, and no panic.

use std::{fs, path::Path, process::Output};

use wholestring_results::Table;

use crate::desk::{Desk, args, transcript};

#[track_caller]
fn refused(output: &Output, file: &str) {
    let message = transcript(output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains(file), "{message}");
    assert!(!message.contains("panicked"), "{message}");
}

/// Parquet that made the reader panic.
#[test]
fn a_damaged_table_is_named() {
    let desk = Desk::new();
    desk.done(&args("run slant.toml --quiet -o results --set model=soft"));
    let damaged = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results/tests/data");
    for name in ["p4201.parquet", "p9353.parquet"] {
        fs::copy(damaged.join(name), desk.path("results/nodes.parquet")).unwrap();
        for command in ["report", "plot"] {
            refused(&desk.run(&[command, "results"]), "nodes.parquet");
        }
    }
}

/// Every command that reads a folder reports the same fault of a file in the same sentence, with
/// the same status, and in no words of a library.
#[test]
fn a_fault_of_a_folder_has_one_message() {
    let desk = Desk::new();
    desk.done(&args("run slant.toml --quiet -o ran --set model=soft"));
    desk.done(&args("bha slant.toml --quiet -o assembly"));
    desk.done(&args("sweep slant.toml --quiet --vary friction=0.1,0.2 -o swept --set model=soft"));
    let part = |text: &str| text.replacen("\"checks\": [", "\"checks\": 3, \"was\": [", 1);
    let changed = |file: &str, change: &dyn Fn(&str) -> String, commands: &[&str]| {
        let valid = fs::read(desk.path(file)).unwrap();
        let text = String::from_utf8_lossy(&valid).into_owned();
        let damaged = change(&text);
        assert_ne!(damaged, text, "{file}");
        fs::write(desk.path(file), damaged).unwrap();
        let folder = file.split('/').next().unwrap();
        let messages: Vec<String> = commands
            .iter()
            .map(|command| {
                let (verb, more) = command.split_once(' ').unwrap_or((*command, ""));
                let output = desk.run(&[&[verb, folder], &args(more)[..]].concat());
                refused(&output, file);
                let message = String::from_utf8(output.stderr).unwrap();
                for word in ["untagged", "enum", "struct ", "Parquet error", "External", "CSV err"]
                {
                    assert!(!message.contains(word), "{command}: {message}");
                }
                message
            })
            .collect();
        assert!(messages.iter().all(|message| *message == messages[0]), "{messages:#?}");
        fs::write(desk.path(file), valid).unwrap();
        messages[0].clone()
    };
    let all = ["report", "plot", "export --to xlsx", "export --to csv"];
    let half = |text: &str| text[..text.len() / 2].to_owned();
    for file in ["ran/summary.json", "assembly/summary.json"] {
        let message = changed(file, &half, &all);
        assert!(message.contains("before it is complete, expected the whole summary"), "{message}");
        let message = changed(file, &part, &all);
        assert!(
            message.contains(&format!("error: {file} is not a file of results: ")),
            "{message}"
        );
    }
    let message = changed("ran/summary.json", &half, &["export --to witsml"]);
    assert!(message.contains("before it is complete"), "{message}");
    for file in ["ran/nodes.parquet", "assembly/bha.parquet"] {
        changed(file, &|_| "not a table, but long enough for one".to_owned(), &all);
    }
    let cut = |text: &str| text.trim_end().rsplit_once(',').unwrap().0.to_owned() + "\n";
    let message = changed("swept/sweep.csv", &cut, &all);
    assert!(message.contains("values, expected"), "{message}");
}

/// A table of another command, or without one of its text columns, is reported with the column; one
/// without its numbers is drawn without them. Absurdly large numbers do not delay drawing.
#[test]
fn foreign_tables_and_wild_numbers_are_no_end() {
    let desk = Desk::new();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    fs::copy(data.join("slant-600-read.csv"), desk.path("read.csv")).unwrap();
    desk.done(&args("calibrate slant.toml --data read.csv --quiet -o calibrated"));
    let bands = desk.path("calibrated/calibration_bands.parquet");
    let whole = Table::read_parquet(&bands).unwrap();
    let without = |names: &[&str]| {
        let rest = whole.columns().iter().filter(|column| !names.contains(&column.name.as_str()));
        Table::new(rest.cloned().collect()).write_parquet(&bands).unwrap();
    };
    without(&["reading"]);
    for command in ["report", "plot"] {
        let output = desk.run(&[command, "calibrated"]);
        refused(&output, "calibration_bands.parquet");
        assert!(transcript(&output).contains("it has no column `reading`"));
    }
    without(&["bit_depth_m", "mean_low_N"]);
    for command in ["report", "plot"] {
        desk.done(&[command, "calibrated"]);
    }
    fs::copy(desk.path("calibrated/calibration_profiles.parquet"), &bands).unwrap();
    refused(&desk.run(&["report", "calibrated"]), "calibration_bands.parquet");

    desk.done(&args("bha slant.toml --quiet -o assembly"));
    let summary = desk.text("assembly/summary.json");
    let wild: serde_json::Value = serde_json::from_str(&summary).unwrap();
    for (number, more) in [(1e300, &["--png"][..]), (-1e300, &[]), (1e20, &[])] {
        let mut wild = wild.clone();
        wild["parts"][0]["od_m"] = number.into();
        wild["parts"][0]["to_bit_m"] = number.into();
        fs::write(desk.path("assembly/summary.json"), wild.to_string()).unwrap();
        desk.done(&["report", "assembly"]);
        desk.done(&[&["plot", "assembly"][..], more].concat());
    }
}

/// Cut to its first columns it has no key column: the page and the plots had no abscissa.
#[test]
fn a_sweep_that_lost_its_columns_is_refused() {
    let desk = Desk::new();
    let sweep = args("sweep slant.toml --quiet --vary friction=0.1,0.2 -o swept --set model=soft");
    desk.done(&sweep);
    let path = desk.path("swept/sweep.csv");
    let whole = fs::read_to_string(&path).unwrap();
    for columns in 0..4 {
        let cut: Vec<String> = whole
            .lines()
            .map(|line| line.split(',').take(columns).collect::<Vec<_>>().join(","))
            .collect();
        fs::write(&path, cut.join("\n") + "\n").unwrap();
        // With its fourth column it is complete.
        if columns < 3 {
            for command in ["report", "plot"] {
                refused(&desk.run(&[command, "swept"]), "sweep.csv");
            }
        } else {
            let message = transcript(&desk.run(&["plot", "swept"]));
            assert!(!message.contains("panicked"), "{message}");
        }
    }
}

/// Each part of a key was once a recursive call.
#[test]
fn keys_of_sixteen_thousand_parts_are_refused() {
    let desk = Desk::new();
    let key = vec!["a"; 16_000].join(".");
    let change = format!("{key}=1");
    for arguments in
        [["check", "slant.toml", "--set", &change], ["sweep", "slant.toml", "--vary", &change]]
    {
        let output = desk.run(&arguments);
        assert_eq!(output.status.code(), Some(2));
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(message.contains("this key has 16000 parts"), "{}", &message[..500]);
    }
    for text in [
        format!("{key} = 1\n"),
        format!("[{key}]\nx = 1\n"),
        format!("name = \"x\"\nx = {}1{}\n", "[".repeat(16_000), "]".repeat(16_000)),
        // The parser loses its depth count after a mistake.
        "x = { f\" = \"d\" [b]\n".repeat(16_000),
        format!("[[sweep]]\nname = \"a\"\ncase = \"slant.toml\"\nvary = [\"{change}\"]\n"),
        format!("[[sweep]]\nname = \"a\"\ncase = \"slant.toml\"\nset = [\"{change}\"]\n"),
    ] {
        fs::write(desk.path("deep.toml"), text).unwrap();
        for command in ["check", "study"] {
            refused(&desk.run(&[command, "deep.toml"]), "deep.toml");
        }
    }
}

/// A survey of more than 64 MB is refused.
#[test]
fn a_survey_that_is_too_large_is_refused() {
    let desk = Desk::new();
    let file = fs::File::create(desk.path("large.csv")).unwrap();
    file.set_len(65 << 20).unwrap();
    let output = desk.run(&["survey", "large.csv"]);
    refused(&output, "large.csv");
    assert!(transcript(&output).contains("65 MB, more than 64 MB"));
}
