//! Commands in the README and the book's first pages, run unchanged one after the other in a fresh
//! folder with the shipped cases.

mod page;

use std::{env, fs, io, path::Path, process::Command};

use crate::{
    command::{Failure, program, succeeds},
    finding::Finding,
    folders::{copy, root, target},
};

use page::{Part, parts};

/// Pages whose commands a reader types.
const PAGES: [&str; 9] = [
    "README.md",
    "docs/src/start.md",
    "docs/src/tour.md",
    "docs/src/which-model.md",
    "docs/src/import.md",
    "docs/src/import-tally.md",
    "docs/src/import-witsml.md",
    "docs/src/import-edm.md",
    "docs/src/import-picks.md",
];

/// Files that these pages assume, from the root of the repository, and their names there.
const THERE: [(&str, &str); 13] = [
    ("cases", "cases"),
    ("studies", "studies"),
    ("crates/import/tests/samples/own", "crates/import/tests/samples/own"),
    ("crates/cli/tests/data/survey.csv", "my-survey.csv"),
    // Files of the reader's own.
    ("crates/import/tests/samples/own/survey-wellpath-report.txt", "survey.txt"),
    ("crates/import/tests/samples/own/tally.csv", "bha7.csv"),
    ("crates/import/tests/samples/own/witsml-trajectory.xml", "trajectory.xml"),
    ("crates/import/tests/samples/own/witsml-tubular.xml", "tubular.xml"),
    ("crates/import/tests/samples/own/witsml-wbgeometry.xml", "wbgeometry.xml"),
    ("crates/import/tests/samples/own/witsml-bharun.xml", "bharun.xml"),
    ("crates/import/tests/samples/own/edm-well.xml", "well.edm.xml"),
    ("crates/import/tests/samples/own/surface-log.las", "trip.las"),
    ("crates/import/tests/samples/own/surface-log.las", "rig.las"),
];

/// The command that the program replaces.
const CARGO: &str = "cargo run --release -- ";

/// Beginnings of lines that are not run here.
const ELSEWHERE: [&str; 7] = [
    // A reader of the sources has them.
    "git clone",
    "cd wholestring",
    // The tests have built it with less optimisation.
    "cargo build --release",
    "cargo install --path crates/cli",
    // It serves until it is stopped: a separate step opens it in a browser.
    "wholestring app",
    "cargo run --release --features app -- app",
    // The step of the Python package installs it.
    "pip install ./crates/python",
];

/// Files whose commands take minutes: their cases are only checked here, and run by
/// `cargo xtask shown --all`.
const MINUTES: [&str; 2] = ["cases/rock-300.toml", "studies/full-hole-system-dynamics.toml"];

/// All commands except those that take minutes.
pub(crate) fn quick() -> Result<Finding, Failure> {
    every(false)
}

/// All commands.
pub(crate) fn all() -> Result<Finding, Failure> {
    every(true)
}

fn every(minutes: bool) -> Result<Finding, Failure> {
    // The commands are written for a shell: quotes, and names with a star.
    if !succeeds(Command::new("sh").args(["-c", "true"])) {
        return Ok(Finding::Skipped("there is no shell `sh` here".into()));
    }
    let built = program("--bin", "wholestring")?;
    let folder = Path::new(built.get_program()).parent().map(Path::to_path_buf).unwrap_or_default();
    let mut path = vec![folder];
    path.extend(env::split_paths(&env::var_os("PATH").unwrap_or_default()));
    let path = env::join_paths(path).map_err(|error| Failure::new(error.to_string()))?;
    for page in PAGES {
        let text = fs::read_to_string(root().join(page));
        let text = text.map_err(|error| Failure::new(format!("{page}: {error}")))?;
        let desk = target().join("shown");
        laid_out(&desk).map_err(|error| Failure::new(format!("{}: {error}", desk.display())))?;
        for part in parts(&text) {
            let line = match part {
                Part::File(name, content) => {
                    let written = fs::write(desk.join(name), content);
                    written.map_err(|error| Failure::new(format!("{name}: {error}")))?;
                    continue;
                }
                Part::Command(line) => line.replace(CARGO, "wholestring "),
            };
            if ELSEWHERE.iter().any(|begin| line.starts_with(begin)) {
                continue;
            }
            let mut shell = Command::new("sh");
            shell.current_dir(&desk).env("PATH", &path).arg("-c");
            match MINUTES.iter().find(|file| line.contains(**file)).filter(|_| !minutes) {
                Some(file) => shell.arg(quick_form(file)),
                None => shell.arg(&line),
            };
            let output = shell.output();
            let output = output.map_err(|error| Failure::new(format!("sh: {error}")))?;
            if !output.status.success() {
                let errors = String::from_utf8_lossy(&output.stderr);
                let reason = format!("{page} shows `{line}`: {}\n{errors}", output.status);
                return Err(Failure::new(reason));
            }
        }
    }
    Ok(Finding::Done)
}

/// Replacement of a command that takes minutes.
fn quick_form(file: &str) -> String {
    match file.starts_with("studies/") {
        // A study without its cases has no check: it must exist.
        true => format!("test -f {file}"),
        false => format!("wholestring check {file}"),
    }
}

/// A fresh folder with the files that the pages assume.
fn laid_out(desk: &Path) -> io::Result<()> {
    if desk.exists() {
        fs::remove_dir_all(desk)?;
    }
    fs::create_dir_all(desk)?;
    for (from, to) in THERE {
        copy(&root().join(from), &desk.join(to))?;
    }
    Ok(())
}
