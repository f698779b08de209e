//! Python: a sufficiently new interpreter, virtual environments, and the example, run on the
//! results of a small case.

use std::{
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, program, run, succeeds},
    finding::Finding,
    folders::{root, target},
};

/// Oldest Python that the example's library supports.
const OLDEST: &str = "3.9";
const LIBRARY: &str = "polars>=1.0,<2";

pub(crate) fn example() -> Result<Finding, Failure> {
    let Some(python) = python(OLDEST) else {
        return Ok(Finding::Skipped(format!("there is no Python {OLDEST} or newer here")));
    };
    let inside = environment(python, &target().join("python"), "import polars", &[LIBRARY]);
    let Some(python) = inside else {
        return Ok(Finding::Skipped(format!(
            "`{LIBRARY}` cannot be installed in a virtual environment here"
        )));
    };
    let results = target().join("python-example");
    run(
        program("--bin", "wholestring")?
            .args(["run", "crates/cli/tests/data/slant.toml"])
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

/// A Python of at least version `oldest`, such as 3.9.
pub(crate) fn python(oldest: &str) -> Option<Command> {
    let check = format!("import sys; sys.exit(sys.version_info < ({}))", oldest.replace('.', ", "));
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

/// The Python of a virtual environment in which `check` runs, with these arguments of
/// `pip install`; created once and kept.
pub(crate) fn environment(
    mut python: Command,
    folder: &Path,
    check: &str,
    install: &[&str],
) -> Option<PathBuf> {
    let inside = inside(folder);
    let is_complete = || succeeds(Command::new(&inside).current_dir(root()).args(["-c", check]));
    if !is_complete() {
        succeeds(python.args(["-m", "venv"]).arg(folder));
        let mut pip = Command::new(&inside);
        pip.current_dir(root()).args(["-m", "pip", "install", "--quiet"]).args(install);
        succeeds(&mut pip);
    }
    is_complete().then_some(inside)
}

/// The interpreter of a virtual environment.
pub(crate) fn inside(folder: &Path) -> PathBuf {
    folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" })
}

fn copy(command: &Command) -> Command {
    let mut copy = Command::new(command.get_program());
    copy.args(command.get_args());
    copy
}
