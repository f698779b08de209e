//! `sweep`: a case for all combinations of given values.

use std::{collections::BTreeSet, fs};

use insta::assert_snapshot;
use wholestring_results::Status;

use crate::{
    desk::{Desk, args, masked, transcript},
    resume::{RECORDS, assert_same},
};

/// Two frictions and three depths, the second of them a range that its step does not divide.
const VARIED: [&str; 4] = ["--vary", "friction=0.2,0.3", "--vary", "bit_depth=300m..600m/200m"];

const CASES: [&str; 6] = [
    "friction=0.2,bit_depth=300m",
    "friction=0.2,bit_depth=500m",
    "friction=0.2,bit_depth=600m",
    "friction=0.3,bit_depth=300m",
    "friction=0.3,bit_depth=500m",
    "friction=0.3,bit_depth=600m",
];

fn sweep<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["sweep", "slant.toml"][..], &VARIED, more].concat()
}

/// `sweep.csv` as rows of cells, the header first.
fn rows(desk: &Desk, folder: &str) -> Vec<Vec<String>> {
    let text = desk.text(&format!("{folder}/sweep.csv"));
    let cells = |line: &str| split(line);
    text.lines().map(cells).collect()
}

/// The cells of a line; commas within quotes do not separate.
pub(crate) fn split(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for letter in line.chars() {
        match letter {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            letter => cells.last_mut().unwrap().push(letter),
        }
    }
    cells
}

fn folders(desk: &Desk, folder: &str) -> BTreeSet<String> {
    fs::read_dir(desk.path(folder))
        .unwrap()
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.path().is_dir())
        .map(|entry| entry.file_name().into_string().unwrap())
        .filter(|name| !name.starts_with('.'))
        .collect()
}

/// The table has the values of the cases' summaries, one row per case, operation and model.
#[test]
fn every_combination_is_a_row() {
    let desk = Desk::new();
    let output = desk.run(&sweep(&["-o", "results"]));
    assert_snapshot!(masked(&transcript(&output)));
    assert_eq!(folders(&desk, "results"), CASES.map(String::from).into());
    let table = rows(&desk, "results");
    let header = &table[0];
    let first = ["friction", "bit_depth", "model", "operation", "bit_depth_m"];
    assert_eq!(header[..5], first);
    assert_eq!(header[header.len() - 3..], ["status", "message", "folder"]);
    assert_eq!(table.len(), 1 + 6 * 4);
    let place = |name: &str| header.iter().position(|cell| cell == name).expect(name);
    for (row, cells) in table[1..].iter().enumerate() {
        assert_eq!(cells.len(), header.len());
        let name = CASES[row / 4];
        assert_eq!(cells[place("folder")], name);
        assert_eq!(format!("friction={},bit_depth={}", cells[0], cells[1]), name);
        let solved = &desk.summary(&format!("results/{name}")).operations[row % 4];
        assert_eq!(cells[place("operation")], solved.operation.name());
        assert_eq!(cells[place("model")], solved.model.name());
        assert_eq!(cells[place("status")], "complete");
        let number = |name: &str| cells[place(name)].parse::<f64>().unwrap();
        assert_eq!(number("bit_depth_m"), solved.bit_depth_m);
        assert_eq!(number("hook_load_N"), solved.scalars.hook_load_N);
        assert_eq!(number("surface_torque_N_m"), solved.scalars.surface_torque_N_m);
        match &solved.statistics {
            Some(statistics) => {
                assert_eq!(number("hook_load_N_std"), statistics["hook_load_N"].std);
                assert_eq!(number("twist_rad_p95"), statistics["twist_rad"].p95);
            }
            None => assert_eq!(cells[place("hook_load_N_std")], ""),
        }
    }
}

/// One thread and two give the same bits, in a sweep and alone; only results are left on disk.
#[test]
fn threads_leave_the_numbers_alone() {
    let desk = Desk::new();
    for jobs in ["1", "2"] {
        let output = desk.done(&sweep(
            &[&["-j", jobs, "-o", jobs, "--keep", "all", "--quiet"], &RECORDS[..]].concat(),
        ));
        assert!(output.stdout.is_empty() && output.stderr.is_empty());
    }
    let table = |folder: &str| fs::read(desk.path(folder).join("sweep.csv")).unwrap();
    assert!(table("1") == table("2"));
    for case in CASES {
        assert_same(&desk, &format!("1/{case}"), &format!("2/{case}"));
    }
    let own = ["--set", "friction=0.3", "--set", "bit_depth=500m"];
    let alone = [&["run", "slant.toml", "-o", "alone"], &RECORDS[..], &own].concat();
    desk.done(&alone);
    assert_same(&desk, "alone", &format!("1/{}", CASES[4]));
}

/// A tuned lift appears in the table, also in a share of the cases.
#[test]
fn a_tuned_lift_is_in_the_table() {
    let desk = Desk::new();
    desk.done(&args(
        "sweep slant.toml --set operation.kind=drill --set hoist.control=tuned-lift \
         --vary model=soft,dynamic --quiet -o results",
    ));
    let table = rows(&desk, "results");
    let place = |name: &str| table[0].iter().position(|cell| cell == name).expect(name);
    let solved = &desk.summary("results/model=dynamic").operations[0];
    let lift = solved.lift.expect("a lift");
    for (name, value) in [
        ("lift_hook_load_N", lift.hook_load_N),
        ("lift_weight_on_bit_N", lift.weight_on_bit_N),
        ("lift_runs", lift.runs as f64),
    ] {
        assert_eq!(table[1][place(name)], "", "a soft string has none");
        assert_eq!(table[2][place(name)].parse(), Ok(value), "{name}");
    }
    // A key with the name of a built-in column has its place on the page.
    let page = desk.text("results/report.html");
    assert!(page.contains("\"heads\":[\"model\",\"Model\""));
}

/// A lift of ten thousand tonnes throws the string out of the hole; the other cases are solved.
#[test]
fn one_case_that_fails() {
    let desk = Desk::new();
    let output = desk.run(&args(
        "sweep slant.toml -o results --set model=dynamic --set operation.kind=trip_out \
         --set hoist.control=hook-load --vary 'hoist.hook_load=120 kN,1e8 N,130 kN'",
    ));
    assert_eq!(output.status.code(), Some(3));
    assert_snapshot!(masked(&transcript(&output)));
    let table = rows(&desk, "results");
    let status = table[0].len() - 3;
    let statuses: Vec<_> = table[1..].iter().map(|row| row[status].as_str()).collect();
    assert_eq!(statuses, ["complete", "failed", "complete"]);
    assert!(table[2][status + 1].contains("diverged"), "{:?}", table[2]);
}

/// A resumed sweep keeps finished cases, continues the one under way and solves the rest, with the
/// results of an uninterrupted sweep.
#[test]
fn a_killed_sweep_goes_on() {
    let desk = Desk::new();
    let long = [&["--set", "dynamics.duration=15 s"], &RECORDS[..]].concat();
    let whole = [&long[..], &["-o", "whole"]].concat();
    desk.done(&sweep(&whole));
    let killed = [&long[..], &["-o", "killed", "--checkpoint", "0.01 s"]].concat();
    // One case is finished, another is under way.
    let any = |name: &str| {
        CASES.iter().any(|case| {
            let folder = desk.path("killed").join(case);
            folder.join(name).exists()
        })
    };
    let finished = || {
        CASES.iter().find(|case| {
            let folder = desk.path("killed").join(case);
            let summary = wholestring_results::Summary::read(&folder.join("summary.json"));
            summary.is_ok_and(|summary| {
                let complete = |summary: &wholestring_results::OperationSummary| {
                    summary.status == Status::Complete
                };
                summary.operations.len() == 4 && summary.operations.iter().all(complete)
            })
        })
    };
    desk.killed(&sweep(&killed), || finished().is_some() && any("checkpoint.bin"));
    let written = |case: &str| {
        let summary = desk.path("killed").join(case).join("summary.json");
        fs::metadata(summary).unwrap().modified().unwrap()
    };
    let done = *finished().unwrap();
    let before = written(done);
    desk.done(&sweep(&[&killed[..], &["--resume"]].concat()));
    assert_eq!(written(done), before);
    assert!(!any("checkpoint.bin"));
    for case in CASES {
        assert_same(&desk, &format!("killed/{case}"), &format!("whole/{case}"));
    }
    let table = |folder: &str| fs::read(desk.path(folder).join("sweep.csv")).unwrap();
    assert!(table("killed") == table("whole"));
    // Other settings make other cases, for which nothing of this counts as finished.
    let other = ["-o", "killed", "--resume", "--set", "model=soft"];
    desk.done(&sweep(&other));
    assert_eq!(rows(&desk, "killed").len(), 1 + 6 * 2);
}

/// The summary of a soft string is kept, the tables of dynamics, or the choice of `--keep`. Results
/// kept before but not now are removed, and a resumed sweep solves the cases that lack tables to be
/// kept.
#[test]
fn what_is_kept_of_a_case() {
    let desk = Desk::new();
    let soft = ["--set", "model=soft", "-o", "results"];
    let dynamic = args(
        "--set model=dynamic --set 'dynamics.duration=0.1 s' \
         --set 'dynamics.settle=0.1 s' -o dynamic",
    );
    let with = |more: &[&'static str]| {
        desk.done(&sweep(more));
    };
    let left = |folder: &str| -> Vec<String> {
        let entries = fs::read_dir(desk.path(folder).join(CASES[1])).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.collect::<BTreeSet<_>>().into_iter().collect()
    };
    let tables = ["contact", "nodes", "time", "wear"].map(|name| format!("{name}.parquet"));
    let tables: Vec<&str> = tables.iter().map(String::as_str).collect();
    let with_tables = [&tables[..3], &["summary.json"], &tables[3..]].concat();
    let with_tables = {
        let mut names = with_tables;
        names.sort_unstable();
        names
    };
    with(&soft);
    assert_eq!(left("results"), ["summary.json"]);
    let table = fs::read(desk.path("results/sweep.csv")).unwrap();
    let case = format!("results/{}", CASES[1]);
    for command in ["report", "plot"] {
        let output = desk.run(&[command, &case]);
        let stderr = String::from_utf8_lossy(&output.stderr).replace('\\', "/");
        assert_eq!(output.status.code(), Some(2));
        let expected = format!(
            "error: {case} lacks nodes.parquet: run the case again; a sweep keeps them with --keep tables\n"
        );
        assert_eq!(stderr, expected);
    }
    with(&[&soft[..], &["--resume", "--keep", "tables"]].concat());
    assert_eq!(left("results"), with_tables);
    for command in ["report", "plot"] {
        desk.done(&[command, &case]);
    }
    with(&[&soft[..], &["--resume", "--keep", "all"]].concat());
    assert!(left("results").contains(&"profile.svg".to_owned()));
    assert!(left("results").contains(&"report.html".to_owned()));
    with(&[&soft[..], &["--keep", "all"]].concat());
    let all = left("results");
    assert!(all.contains(&"profile.svg".to_owned()) && all.contains(&"report.html".to_owned()));
    fs::remove_dir_all(desk.path(&case).join("plots")).unwrap();
    with(&soft);
    assert_eq!(left("results"), ["summary.json"]);
    assert!(fs::read(desk.path("results/sweep.csv")).unwrap() == table);
    with(&[&soft[..], &["--csv"]].concat());
    assert!(left("results").contains(&"nodes.csv".to_owned()));
    with(&dynamic);
    assert_eq!(left("dynamic"), with_tables);
    with(&[&dynamic[..], &["--keep", "summary"]].concat());
    assert_eq!(left("dynamic"), ["summary.json"]);
    let output = desk.run(&sweep(&["--csv", "--keep", "summary"]));
    assert_eq!(output.status.code(), Some(2));
}

/// Every case is in one share. Shares in folders of their own have tables that together equal the
/// whole; in one folder each adds to the table, which finally equals the whole to the byte.
#[test]
fn shards_make_up_the_whole() {
    let desk = Desk::new();
    let soft = ["--set", "model=soft"];
    let with = |more: &[&'static str]| sweep(&[&soft[..], more].concat());
    desk.done(&with(&["-o", "whole"]));
    let whole = rows(&desk, "whole");
    let mut parts = Vec::new();
    for (shard, folder) in [("1/4", "1"), ("2/4", "2"), ("3/4", "3"), ("4/4", "4")] {
        desk.done(&with(&["-o", folder, "--shard", shard]));
        let mut part = rows(&desk, folder);
        assert_eq!(part.remove(0), whole[0]);
        parts.extend(part);
        desk.done(&with(&["-o", "parts", "--shard", shard]));
        assert_eq!(rows(&desk, "parts").len(), parts.len() + 1);
    }
    parts.sort();
    let mut sorted = whole[1..].to_vec();
    sorted.sort();
    assert_eq!(parts, sorted);
    assert_eq!(folders(&desk, "parts"), CASES.map(String::from).into());
    let bytes = |folder: &str| fs::read(desk.path(folder).join("sweep.csv")).unwrap();
    assert!(bytes("parts") == bytes("whole"));
    // A call over the whole folder solves nothing and removes all traces of the shares.
    desk.done(&with(&["-o", "parts", "--resume"]));
    assert!(bytes("parts") == bytes("whole"));
    assert!(!desk.path("parts/.shares").exists());
}

/// Number of trials of simultaneous shares, if not the few of every test run.
const SHARE_TRIALS: &str = "WHOLESTRING_SHARE_TRIALS";

/// Four to sixteen shares that start at once and write to one folder, like the jobs of a cluster:
/// all succeed, and the last one to end leaves the table of all.
#[test]
fn shares_at_once_make_up_the_whole() {
    let trials = std::env::var(SHARE_TRIALS).map_or(3, |count| count.parse::<usize>().unwrap());
    let desk = Desk::new();
    let with = |more: &[&str]| {
        let soft = ["--set", "model=soft", "--quiet", "-j", "1"];
        sweep(&[&soft[..], more].concat()).into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    let args =
        |words: &[String]| desk.command(&words.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(args(&with(&["-o", "whole"])).status().unwrap().success());
    let whole = fs::read(desk.path("whole/sweep.csv")).unwrap();
    for trial in 0..trials {
        let (folder, shares) = (format!("trial-{trial}"), 4 + 5 * trial % 13);
        let begun: Vec<_> = (1..=shares)
            .map(|share| {
                let share = format!("{share}/{shares}");
                let more = ["-o", &folder, "--resume", "--shard", &share];
                let mut command = args(&with(&more));
                command.stderr(std::process::Stdio::piped()).spawn().unwrap()
            })
            .collect();
        for share in begun {
            let output = share.wait_with_output().unwrap();
            assert!(output.status.success(), "{}", transcript(&output));
        }
        assert!(fs::read(desk.path(&folder).join("sweep.csv")).unwrap() == whole, "{folder}");
        assert!(!desk.path(&folder).join("sweep.csv.partial").exists(), "{folder}");
        fs::remove_dir_all(desk.path(&folder)).unwrap();
    }
}

/// A case that failed in one share is a row of the table that another share writes.
#[test]
fn a_failure_of_another_share_is_in_the_table() {
    let desk = Desk::new();
    let with =
        |more: &[&'static str]| sweep(&[&["--set", "model=soft", "--quiet"][..], more].concat());
    // A file in place of the case's folder: the case cannot be written.
    fs::create_dir_all(desk.path("parts")).unwrap();
    fs::write(desk.path("parts").join(CASES[0]), "").unwrap();
    let failed = desk.run(&with(&["-o", "parts", "--shard", "1/2"]));
    assert_eq!(failed.status.code(), Some(3), "{}", transcript(&failed));
    desk.done(&with(&["-o", "parts", "--shard", "2/2"]));
    let table = rows(&desk, "parts");
    let status = table[0].iter().position(|name| name == "status").unwrap();
    let failed: Vec<_> = table.iter().filter(|row| row[status] == "failed").collect();
    assert_eq!(failed.len(), 1, "{table:?}");
    assert!(failed[0].contains(&CASES[0].to_owned()), "{failed:?}");
}

/// Values that are invalid folder names, or that some system treats as equal, are replaced with
/// numbers.
#[test]
fn folders_that_cannot_bear_their_values() {
    let desk = Desk::new();
    let soft = ["--set", "model=soft", "--set", "operation.kind=trip_out"];
    let name = |letter: &str| format!("name={},{}", letter.repeat(110), letter.repeat(120));
    desk.done(&[&["sweep", "slant.toml", "-o", "long", "--vary", &name("x")], &soft[..]].concat());
    assert_eq!(folders(&desk, "long"), ["case-1", "case-2"].map(String::from).into());
    desk.done(
        &[&["sweep", "slant.toml", "-o", "case", "--vary", "name=well,Well"], &soft[..]].concat(),
    );
    assert_eq!(folders(&desk, "case"), ["case-1", "case-2"].map(String::from).into());
    // By default, the folder has the name of the case.
    desk.done(&[&["sweep", "slant.toml", "--vary", "rpm=60,70"], &soft[..]].concat());
    assert!(desk.path("out/Straight slant sweep/rpm=60/summary.json").exists());
}

/// Mistakes are reported before anything is solved, each with its place underlined.
#[test]
fn mistakes_are_underlined() {
    let desk = Desk::new();
    let several = [
        "friction",
        "rpm=60..120",
        "bit_depth=300m..600/100m",
        "wob=1 tf,,2 tf",
        "operation.rop=10 m/h..30 m/h/0 m/h",
        "mesh.element_length=1m..30m/1mm",
        "dynamics.seed=1,2,1",
        "well.hole.0.friction=0.1..",
        "rpm=60,70",
    ];
    let arguments: Vec<&str> = several.iter().flat_map(|text| ["--vary", text]).collect();
    let answer = |arguments: &[&str]| {
        let output = desk.run(&[&["sweep", "slant.toml", "-o", "results"], arguments].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(!desk.path("results").exists());
        transcript(&output)
    };
    assert_snapshot!("sweep_mistakes_of_form", answer(&arguments));
    for (name, text) in [
        ("sweep_unknown_key", "frction=0.1,0.2"),
        ("sweep_value_out_of_range", "bit_depth=500m,600m,700m"),
        ("sweep_range_out_of_range", "bit_depth=500m..900m/200m"),
        ("sweep_wrong_unit", "bit_depth=500m,60 bar"),
        ("sweep_one_value", "friction=much"),
    ] {
        assert_snapshot!(name, answer(&["--vary", text]));
    }
    let twice = answer(&["--vary", "rpm=60,70", "--vary", "rpm=80"]);
    assert_snapshot!("sweep_varied_twice", twice);
    assert_snapshot!("sweep_nothing_varied", answer(&[]));
    for shard in ["0/4", "5/4", "1", "a/b", "1/0"] {
        answer(&["--vary", "rpm=60,70", "--shard", shard]);
    }
    answer(&["--vary", "rpm=60,70", "-j", "0"]);
    let many = ["rpm=1..9000/1", "dynamics.seed=1..9000/1"];
    let many: Vec<&str> = many.iter().flat_map(|text| ["--vary", text]).collect();
    assert_snapshot!("sweep_too_many_cases", answer(&many));
}

/// Ctrl-C keeps all finished results.
#[cfg(unix)]
#[test]
fn an_interrupted_sweep_goes_on() {
    use std::time::Duration;

    let desk = Desk::new();
    let long = ["--csv", "--set", "dynamics.duration=15 s"];
    desk.done(&sweep(&[&long[..], &["-o", "whole"]].concat()));
    let stopped = sweep(&[&long[..], &["-o", "stopped", "-j", "1"]].concat());
    let count = || fs::read_dir(desk.path("stopped")).map_or(0, |all| all.count());
    assert_eq!(
        desk.interrupted(&stopped, || count() >= 3, Duration::ZERO),
        "interrupted: partial results are in stopped\n\
         to continue, run the sweep again with --resume\n"
    );
    assert!(desk.path("stopped/sweep.csv").exists());
    desk.done(&[&stopped[..], &["--resume"]].concat());
    let table = |folder: &str| fs::read(desk.path(folder).join("sweep.csv")).unwrap();
    assert!(table("stopped") == table("whole"));
}
