//! Ownership of folders: results are not replaced by those of another case, and no two programs
//! write to one folder.

use std::{collections::BTreeSet, fs, path::Path, process::Output};

use crate::{
    bit_test,
    desk::{Desk, args, text},
};

const SOFT: [&str; 2] = ["--set", "model=soft"];

fn words(output: &Output) -> (i32, String, String) {
    let status = output.status.code().unwrap();
    (status, text(&output.stdout), text(&output.stderr))
}

fn soft(desk: &Desk, more: &[&str]) -> (i32, String, String) {
    words(&desk.run(&[&["run", "slant.toml"], &SOFT[..], more].concat()))
}

/// Output of a command that is refused.
#[track_caller]
fn refused(desk: &Desk, arguments: &[&str]) -> String {
    let (status, _, stderr) = words(&desk.run(arguments));
    assert_eq!(status, 2, "{stderr}");
    stderr
}

#[test]
fn another_case_goes_to_a_folder_of_its_own() {
    let desk = Desk::new();
    let friction =
        |folder: &str| desk.summary(folder).settings["well"]["hole"][0]["friction"].clone();
    let (status, _, stderr) = soft(&desk, &[]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    let first = fs::read(desk.path("out/Straight slant/summary.json")).unwrap();
    let (status, stdout, stderr) = soft(&desk, &["--set", "friction=0.4"]);
    assert_eq!(status, 0);
    assert_eq!(
        stderr,
        "note: out/Straight slant holds other results and is not changed: these are written to out/Straight slant-2\n"
    );
    assert!(stdout.ends_with("Results in out/Straight slant-2\n"), "{stdout}");
    assert_eq!(friction("out/Straight slant-2")["kinetic"], 0.4);
    assert_eq!(fs::read(desk.path("out/Straight slant/summary.json")).unwrap(), first);
    // Each again, into its own folder, whatever its name and units.
    assert_eq!(soft(&desk, &["--set", "friction=0.4"]).0, 0);
    let (status, stdout, stderr) = soft(&desk, &["--set", "units=metric"]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    assert!(stdout.ends_with("Results in out/Straight slant\n"), "{stdout}");
    assert!(!desk.path("out/Straight slant-3").exists());
    // With permission, it replaces the existing results.
    let (status, stdout, _) = soft(&desk, &["--set", "friction=0.5", "--overwrite"]);
    assert_eq!(status, 0);
    assert!(stdout.ends_with("Results in out/Straight slant\n"), "{stdout}");
    assert_eq!(friction("out/Straight slant")["kinetic"], 0.5);
}

#[test]
fn a_named_folder_with_another_case_is_refused() {
    let desk = Desk::new();
    let records = args("-o results --csv --set records.spectra=hook_load");
    desk.done(&[&["run", "slant.toml", "--quiet"], &records[..]].concat());
    desk.done(&["plot", "results"]);
    fs::write(desk.path("results/notes.txt"), "mine").unwrap();
    let other = ["-o", "results", "--set", "friction=0.4"];
    let (status, stdout, stderr) = soft(&desk, &other);
    assert_eq!((status, stdout.as_str()), (2, ""));
    assert_eq!(
        stderr,
        "error: results holds the run \"Straight slant\" with other settings or data\n\
         name another folder with -o, or add --overwrite to replace its contents\n"
    );
    assert!(desk.path("results/time.csv").exists());
    // It removes the files of the old run, and nothing else.
    assert_eq!(soft(&desk, &[&other[..], &["--overwrite"]].concat()).0, 0);
    assert_eq!(desk.summary("results").operations.len(), 2);
    for gone in ["time.csv", "spectra.parquet", "spectra.csv", "plots"] {
        assert!(!desk.path("results").join(gone).exists(), "{gone}");
    }
    assert!(desk.path("results/notes.txt").exists());
    // A run is not a sweep.
    let sweep = args("sweep slant.toml --vary friction=0.1 -o results");
    let stderr = refused(&desk, &[&sweep[..], &SOFT].concat());
    assert!(stderr.contains("results holds the run of another case"), "{stderr}");
    // Results of a version that did not record their case.
    let path = desk.path("results/summary.json");
    let mut summary: serde_json::Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    summary.as_object_mut().unwrap().remove("identity");
    fs::write(&path, summary.to_string()).unwrap();
    fs::remove_file(desk.path("results/.wholestring")).unwrap();
    let (status, _, stderr) = soft(&desk, &other);
    assert_eq!(status, 2);
    assert!(stderr.contains("results without a record of their case"), "{stderr}");
}

/// Files of a user with the names of results, in a folder that no command wrote to.
#[test]
fn files_of_somebody_else_are_not_replaced() {
    let desk = Desk::new();
    let own = ["time.csv", "report.html", "frames.parts/mine.csv", "in/nodes.csv"];
    let put = |name: &str| {
        let path = desk.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "mine").unwrap();
    };
    own.iter().for_each(|name| put(name));
    put("swept/friction=0.1/nodes.csv");
    put("plain/notes.txt");
    let stderr = refused(&desk, &[&["run", "slant.toml", "-o", "."], &SOFT[..]].concat());
    assert_eq!(
        stderr,
        "error: . holds frames.parts, report.html, time.csv, which results would replace, and no \
         record that they are results\n\
         name another folder with -o, or add --overwrite to replace these files\n"
    );
    let sweep = args("sweep slant.toml --vary friction=0.1 -o swept");
    let stderr = refused(&desk, &[&sweep[..], &SOFT].concat());
    assert!(stderr.contains("swept/friction=0.1 holds nodes.csv, which"), "{stderr}");
    let plan = refused(&desk, &args("plan slant.toml -o ."));
    assert!(plan.contains("report.html"), "{plan}");
    for name in own.iter().chain(&["swept/friction=0.1/nodes.csv"]) {
        assert_eq!(fs::read(desk.path(name)).unwrap(), b"mine", "{name}");
    }
    // The default folder of results is passed over, and files of other names are in nobody's way.
    put("out/Straight slant/time.csv");
    assert_eq!(soft(&desk, &[]).0, 0);
    assert!(desk.path("out/Straight slant-2/summary.json").exists());
    assert_eq!(soft(&desk, &["-o", "plain"]).0, 0);
    // The user agrees to it.
    assert_eq!(soft(&desk, &["-o", "in", "--overwrite"]).0, 0);
    assert!(!desk.path("in/nodes.csv").exists());
}

#[test]
fn sweeps_are_not_replaced_by_other_sweeps() {
    let desk = Desk::new();
    let sweep = |more: &[&str]| {
        let arguments = [&["sweep", "slant.toml", "--quiet"], &SOFT[..], more].concat();
        words(&desk.run(&arguments))
    };
    let two = ["--vary", "friction=0.1,0.2"];
    let other = ["--vary", "friction=0.1,0.3"];
    assert_eq!(sweep(&two).0, 0);
    assert_eq!(sweep(&two).0, 0);
    let table = desk.path("out/Straight slant sweep/sweep.csv");
    let first = fs::read(&table).unwrap();
    assert_eq!(sweep(&other).0, 0);
    assert_eq!(fs::read(&table).unwrap(), first);
    assert!(desk.path("out/Straight slant sweep-2/friction=0.3").exists());
    let into = ["-o", "out/Straight slant sweep"];
    assert_eq!(sweep(&[&other[..], &into].concat()).0, 2);
    assert_eq!(sweep(&[&other[..], &into, &["--overwrite"]].concat()).0, 0);
    assert_ne!(fs::read(&table).unwrap(), first);
    // The case in both sweeps was solved again, the other is removed.
    assert!(desk.path("out/Straight slant sweep/friction=0.1").exists());
    assert!(!desk.path("out/Straight slant sweep/friction=0.2").exists());
}

/// A case counts as finished only for the same settings: a bend, an eccentricity and the tolerance
/// of the lift were once missing from the comparison.
#[test]
fn a_resumed_sweep_does_not_take_the_answers_of_another_case() {
    let desk = Desk::new();
    let with = |more: &[&str]| {
        let sweep = args("sweep slant.toml --vary friction=0.1 -o swept");
        words(&desk.run(&[&sweep[..], &SOFT, more].concat()))
    };
    assert_eq!(with(&[]).0, 0);
    let path = desk.path("swept/friction=0.1/summary.json");
    let written = || fs::metadata(&path).unwrap().modified().unwrap();
    let first = written();
    let (status, _, stderr) = with(&["--resume"]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    assert_eq!(written(), first);
    let mut before = first;
    for change in ["string.0.bend=1 deg", "string.0.eccentricity=2 mm", "hoist.tolerance=0.02"] {
        // A bend of the only component is at the given place; without a bend, the place is unused.
        let place = ["--set", "string.0.bend_at=20 m"];
        let place = if change.contains("bend") { &place[..] } else { &[] };
        let (status, _, stderr) = with(&[&["--resume", "--set", change], place].concat());
        assert_eq!(status, 0, "{stderr}");
        assert!(stderr.contains("it is of another case"), "{change}: {stderr}");
        assert!(stderr.contains("it starts again"), "{change}: {stderr}");
        assert_ne!(written(), before, "{change}");
        before = written();
    }
}

/// Only the soft string of the first operation is on disk: the run was killed before its first
/// checkpoint.
#[test]
fn a_run_that_ended_before_its_first_checkpoint_is_not_finished() {
    let desk = Desk::new();
    desk.done(&["run", "slant.toml", "-o", "results", "--quiet"]);
    let path = desk.path("results/summary.json");
    let mut summary: serde_json::Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    let resume = || refused(&desk, &["run", "slant.toml", "--resume", "results"]);
    let stderr = resume();
    assert!(stderr.contains("is finished: nothing is left to do"), "{stderr}");
    summary["operations"].as_array_mut().unwrap().truncate(1);
    assert_eq!(summary["operations"][0]["status"], "complete");
    fs::write(&path, summary.to_string()).unwrap();
    assert_eq!(
        resume(),
        "error: there is no checkpoint in results: the run ended before its first one, with 1 of 4 answers\n\
         run the case without --resume to start again\n"
    );
    let other = args(
        "run slant.toml --resume results --set 'string.0.bend=1 deg' \
         --set 'string.0.bend_at=20 m'",
    );
    let stderr = refused(&desk, &other);
    assert!(stderr.contains("`string.0.bend_at_m` is not given there and 20.0 here"), "{stderr}");
    assert!(!stderr.contains("is finished"), "{stderr}");
}

#[test]
fn a_second_program_is_kept_out_and_an_unfinished_run_is_kept() {
    let desk = Desk::new();
    let long = args("run slant.toml -o results --set 'dynamics.duration=4000 s'");
    let often = [&long[..], &["--checkpoint", "0.01 s"]].concat();
    let mut child = desk.begun(&often, || desk.path("results/checkpoint.bin").exists());
    assert_eq!(
        refused(&desk, &long),
        "error: another run is writing to results\n\
         wait until it has ended, or name another folder with -o\n"
    );
    // It can be neither replaced nor continued.
    refused(&desk, &[&long[..], &["--overwrite"]].concat());
    let resume = args("run slant.toml --resume results --set 'dynamics.duration=4000 s'");
    let stderr = refused(&desk, &resume);
    assert!(stderr.contains("another run is writing"), "{stderr}");
    child.kill().unwrap();
    child.wait().unwrap();
    let checkpoint = fs::read(desk.path("results/checkpoint.bin")).unwrap();
    assert_eq!(
        refused(&desk, &long),
        "error: results holds an unfinished run of this case\n\
         to continue with it, run the case with --resume results; to start again, add --overwrite\n"
    );
    assert_eq!(fs::read(desk.path("results/checkpoint.bin")).unwrap(), checkpoint);
    // Nor does another case replace it.
    assert_eq!(soft(&desk, &["-o", "results"]).0, 2);
    assert_eq!(fs::read(desk.path("results/checkpoint.bin")).unwrap(), checkpoint);
    assert_eq!(soft(&desk, &["-o", "results", "--overwrite"]).0, 0);
    assert!(!desk.path("results/checkpoint.bin").exists());
}

/// The summary and nothing else, with the version that computed it, together with the other machine
/// interfaces of the program.
#[test]
fn programs_are_told_in_their_own_words() {
    let desk = Desk::new();
    let (status, stdout, stderr) = soft(&desk, &["--json", "-o", "results"]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    let printed: serde_json::Value = serde_json::from_str(&stdout).unwrap();
    let written = fs::read(desk.path("results/summary.json")).unwrap();
    let written: serde_json::Value = serde_json::from_slice(&written).unwrap();
    assert_eq!(printed, written);
    assert_eq!(printed["engine_version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(printed["identity"].as_str().unwrap().len(), 32);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let (status, script, _) = words(&desk.run(&["completions", shell]));
        assert_eq!(status, 0);
        assert!(script.contains("wholestring") && script.contains("overwrite"), "{shell}");
    }
    let (status, page, _) = words(&desk.run(&["man"]));
    assert_eq!(status, 0);
    for part in [".TH wholestring 1", ".SH \"WHOLESTRING SWEEP\"", "overwrite", "Exit status"] {
        assert!(page.contains(part), "{part}");
    }
}

/// Each of two sweeps of one case continues with its own folder; a sweep with more values than
/// before continues with the folder that has some of them.
#[test]
fn a_resumed_sweep_finds_its_folder() {
    let desk = Desk::new();
    let sweep = |values: &str, more: &[&str]| {
        let vary = format!("friction={values}");
        let sweep = ["sweep", "slant.toml", "--quiet", "--vary", &vary];
        let output = desk.run(&[&sweep[..], &SOFT, more].concat());
        assert!(output.status.success(), "{}", words(&output).2);
    };
    let written = |name: &str| {
        let path = desk.path("out").join(name).join("summary.json");
        fs::metadata(path).unwrap().modified().unwrap()
    };
    sweep("0.1,0.2", &[]);
    sweep("0.1,0.3", &[]);
    let names = ["Straight slant sweep/friction=0.1", "Straight slant sweep-2/friction=0.3"];
    let before = names.map(written);
    sweep("0.1,0.3", &["--resume"]);
    sweep("0.1,0.2,0.25", &["--resume"]);
    assert_eq!(names.map(written), before);
    written("Straight slant sweep/friction=0.25");
    // A sweep that shares no case with either has a folder of its own.
    sweep("0.4", &["--resume"]);
    written("Straight slant sweep-3/friction=0.4");
}

/// Files in a folder and below it.
fn files(folder: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        if entry.file_type().unwrap().is_dir() {
            found.extend(files(&entry.path()).iter().map(|file| format!("{name}/{file}")));
        } else {
            found.insert(name);
        }
    }
    found
}

/// Whatever a command wrote, with all optional pictures and tables, another one replaces it with
/// `--overwrite` as if the folder had been empty.
#[test]
fn nothing_stale_is_left() {
    let desk = bit_test::desk();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    for name in ["slant.toml", "bent-motor.toml"] {
        fs::copy(cases.join(name), desk.path(&format!("shipped-{name}"))).unwrap();
    }
    let read = "Bit depth (m),Pick-up (kN),Slack-off (kN),Rotating (kN)\n\
                300,330,300,310\n700,410,340,370\n1200,470,390,420\n";
    fs::write(desk.path("read.csv"), read).unwrap();
    let options = "-o results --overwrite";
    desk.done(&args("run slant.toml --set model=soft -o clean"));
    let clean = files(&desk.path("clean"));
    for (command, left) in [
        ("run slant.toml --set model=soft --csv", "nodes.csv"),
        ("sweep slant.toml --set model=soft --vary friction=0.1,0.2 --keep all --csv", "sweep.csv"),
        (
            "bha shipped-bent-motor.toml --csv --toolface 0deg --weight 20kN --inclination 5deg",
            "views.svg",
        ),
        ("modes slant.toml --png --set modes.count=3", "mode_shapes.png"),
        ("plan slant.toml --png --set plan.depths=4", "plan.xlsx"),
        ("reach slant.toml --png --to 1500m --operation drill", "reach.png"),
        (
            "bit-test rock.toml --csv --set bit_test.wob=[\"10kN\"] --set bit_test.rpm=[240]",
            "drill-off.svg",
        ),
        ("calibrate shipped-slant.toml --data read.csv --png", "friction.toml"),
    ] {
        desk.done(&[args(command), args(options)].concat());
        let all = files(&desk.path("results"));
        assert!(all.contains(left), "{command} left {all:?}");
        desk.done(&args(&format!("run slant.toml --set model=soft {options}")));
        assert_eq!(files(&desk.path("results")), clean, "{command}");
    }
}
