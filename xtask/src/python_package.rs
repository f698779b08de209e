//! The Python package: built into a virtual environment as a user does, then its tests, the examples
//! in its documentation, and the checkers of its types.

use std::{
    env,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, run, run_counted, succeeds},
    finding::Finding,
    folders::{root, target},
    python::{environment, python},
};

/// Oldest Python that the package supports.
const OLDEST: &str = "3.10";

/// Since when it installs groups of dependencies.
const PIP: &str = "pip>=25.1";

const CHECK: &str = "import maturin, mypy, pandas, pint, polars, pyright, pytest, ruff, tqdm";

pub(crate) fn package() -> Result<Finding, Failure> {
    let inside = match prepared() {
        Ok(inside) => inside,
        // Where nobody looks, what was not tested would pass for tested.
        Err(reason) if env::var_os("CI").is_some() => return Err(Failure::new(reason)),
        Err(reason) => return Ok(Finding::Skipped(reason)),
    };
    // Optimised as the other tests are, and of the parts that these are made of.
    let profile = "--config-settings=build-args=--profile=dev";
    let mut install = module(&inside, "pip");
    install.args(["install", "--quiet", "--no-build-isolation", "--no-deps", "--force-reinstall"]);
    run(install.arg(profile).arg("."), "the package must build")?;
    let checks: [(&str, &[&str], &str); 4] = [
        ("ruff", &["format", "--check", "."], "run `ruff format` in crates/python"),
        ("ruff", &["check", "."], "warnings count as errors"),
        ("mypy", &[], "the types must hold"),
        ("pyright", &[], "the types must hold"),
    ];
    for (name, arguments, advice) in checks {
        run(module(&inside, name).args(arguments), advice)?;
    }
    run_counted(&mut module(&inside, "pytest")).map(Finding::Tested)
}

/// The Python of a virtual environment with what the tests need.
fn prepared() -> Result<PathBuf, String> {
    let python = python(OLDEST).ok_or(format!("there is no Python {OLDEST} or newer here"))?;
    let folder = target().join("python-package");
    let missing = || "what its tests need cannot be installed in a virtual environment here".to_owned();
    let inside = environment(python, &folder, "import pip", &[]).ok_or_else(missing)?;
    let has_all = || succeeds(Command::new(&inside).current_dir(root()).args(["-c", CHECK]));
    if !has_all() {
        succeeds(module(&inside, "pip").args(["install", "--quiet", "--upgrade", PIP]));
        succeeds(module(&inside, "pip").args(["install", "--quiet", "--group", "test"]));
    }
    has_all().then_some(inside).ok_or_else(missing)
}

fn module(python: &Path, name: &str) -> Command {
    let mut command = Command::new(python);
    command.current_dir(root().join("crates/python")).args(["-m", name]);
    command
}
