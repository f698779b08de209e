//! The Python example, run on the results of a small case.

use std::{path::PathBuf, process::Command};

use crate::{
    command::{Failure, cargo, run, succeeds},
    finding::Finding,
    folders::{root, target},
};

/// Oldest Python that the example's library supports.
const OLDEST: &str = "3.9";
const LIBRARY: &str = "polars>=1.0,<2";

pub(crate) fn example() -> Result<Finding, Failure> {
    let Some(python) = python() else {
        return Ok(Finding::Skipped(format!("there is no Python {OLDEST} or newer here")));
    };
    let Some(python) = with_library(python) else {
        return Ok(Finding::Skipped(format!(
            "`{LIBRARY}` cannot be installed in a virtual environment here"
        )));
    };
    let results = target().join("python-example");
    run(
        cargo()
            .args(["run", "--quiet", "--package", "wholestring-cli", "--", "run"])
            .arg("crates/cli/tests/data/slant.toml")
            .args(["--quiet", "--overwrite", "-o"])
            .arg(&results),
        "the example needs its results",
    )?;
    run(
        Command::new(python).current_dir(root()).arg("examples/read_results.py").arg(&results),
        "the example reads what a run leaves",
    )?;
    Ok(Finding::Done)
}

/// A Python that is new enough.
fn python() -> Option<Command> {
    let check = format!("import sys; sys.exit(sys.version_info < ({}))", OLDEST.replace('.', ", "));
    [&["python3"][..], &["python"], &["py", "-3"]]
        .into_iter()
        .map(|words| {
            let mut command = Command::new(words[0]);
            command.args(&words[1..]);
            command
        })
        .find_map(|mut command| {
            let found = succeeds(copy(&command).args(["-c", &check]));
            found.then(|| {
                command.current_dir(root());
                command
            })
        })
}

/// The Python of a virtual environment that has the library; made once and kept.
fn with_library(mut python: Command) -> Option<PathBuf> {
    let environment = target().join("python");
    let inside = environment.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let has_library = || succeeds(Command::new(&inside).args(["-c", "import polars"]));
    if !has_library() {
        succeeds(python.args(["-m", "venv"]).arg(&environment));
        succeeds(Command::new(&inside).args(["-m", "pip", "install", "--quiet", LIBRARY]));
    }
    has_library().then_some(inside)
}

fn copy(command: &Command) -> Command {
    let mut copy = Command::new(command.get_program());
    copy.args(command.get_args());
    copy
}
