//! The Python package: installed into a fresh virtual environment as a user does, where the
//! README's quick start runs; then its tests, the examples in its documentation, and checks of its
//! types and its style.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, run, run_counted, succeeds},
    finding::Finding,
    folders::{root, target},
    python::{environment, inside, python},
};

/// Oldest Python that the package supports.
pub(crate) const OLDEST: &str = "3.10";

/// First version that installs groups of dependencies.
const PIP: &str = "pip>=25.1";

/// Whether everything in the group `test` of `pyproject.toml` is installed.
const CHECK: &str = "\
import importlib.metadata as there, re
try:
    import tomllib
except ImportError:
    from pip._vendor import tomli as tomllib
group = tomllib.load(open('pyproject.toml', 'rb'))['dependency-groups']['test']
for one in group:
    there.version(re.match(r'[A-Za-z0-9_.-]+', one)[0])";

pub(crate) fn package() -> Result<Finding, Failure> {
    let with_tests = match prepared() {
        Ok(with_tests) => with_tests,
        // In CI, an untested step would count as passed.
        Err(reason) if env::var_os("CI").is_some() => return Err(Failure::new(reason)),
        Err(reason) => return Ok(Finding::Skipped(reason)),
    };
    quick_start()?;
    install(&with_tests, &["--no-deps", "--force-reinstall"])?;
    let checks: [(&str, &[&str], &str); 4] = [
        ("ruff", &["format", "--check", "."], "run `ruff format` in crates/python"),
        ("ruff", &["check", "."], "warnings count as errors"),
        ("mypy", &[], "the types must hold"),
        ("pyright", &["--pythonpath"], "the types must hold"),
    ];
    for (name, arguments, advice) in checks {
        let mut check = module(&with_tests, name);
        check.args(arguments);
        if arguments.contains(&"--pythonpath") {
            check.arg(&with_tests);
        }
        run(&mut check, advice)?;
    }
    run_counted(&mut module(&with_tests, "pytest")).map(Finding::Tested)
}

/// The README's quick start, in an environment with only the package and its dependencies.
fn quick_start() -> Result<(), Failure> {
    let example = readme_quick_start()?;
    let folder = target().join("python-fresh");
    if folder.exists() {
        let removed = fs::remove_dir_all(&folder);
        removed.map_err(|error| Failure::new(format!("{}: {error}", folder.display())))?;
    }
    let mut python = python(OLDEST).ok_or_else(|| Failure::new("Python is gone"))?;
    run(python.args(["-m", "venv"]).arg(&folder), "a fresh environment is needed")?;
    let fresh = inside(&folder);
    install(&fresh, &[])?;
    run(
        Command::new(fresh).current_dir(root()).args(["-c", &example]),
        "the quick start in README.md must run unchanged",
    )
}

/// The first Python example of the README.
pub(crate) fn readme_quick_start() -> Result<String, Failure> {
    let readme = fs::read_to_string(root().join("README.md"));
    let readme = readme.map_err(|error| Failure::new(format!("README.md: {error}")))?;
    let example = first_python(&readme).ok_or_else(|| Failure::new("README.md shows no Python"))?;
    Ok(example.to_owned())
}

/// The first block of Python on a page.
fn first_python(page: &str) -> Option<&str> {
    let (_, rest) = page.split_once("\n```python\n")?;
    rest.split_once("\n```").map(|(block, _)| block)
}

/// `pip install .`, optimised as the other tests are, with the crates compiled for them.
fn install(python: &Path, options: &[&str]) -> Result<(), Failure> {
    let mut install = module(python, "pip");
    install.env("MATURIN_PEP517_ARGS", "--profile=dev");
    install.args(["install", "--quiet", "--disable-pip-version-check"]).args(options);
    run(install.arg("."), "the package must build")
}

/// The Python of a virtual environment with the dependencies of the tests.
fn prepared() -> Result<PathBuf, String> {
    let python = python(OLDEST).ok_or(format!("there is no Python {OLDEST} or newer here"))?;
    let folder = target().join("python-package");
    let missing =
        || "what its tests need cannot be installed in a virtual environment here".to_owned();
    let python = environment(python, &folder, "import pip", &[]).ok_or_else(missing)?;
    let has_all = || succeeds(module(&python, "").args(["-c", CHECK]));
    if !has_all() {
        succeeds(module(&python, "pip").args(["install", "--quiet", "--upgrade", PIP]));
        succeeds(module(&python, "pip").args(["install", "--quiet", "--group", "test"]));
    }
    if has_all() { Ok(python) } else { Err(missing()) }
}

/// A Python module to run in the package's folder; only Python if its name is empty.
fn module(python: &Path, name: &str) -> Command {
    let mut command = Command::new(python);
    command.current_dir(root().join("crates/python"));
    if !name.is_empty() {
        command.args(["-m", name]);
    }
    command
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_block_is_found() {
        let page = "text\n```sh\nls\n```\n\n```python\nimport a\na.b()\n```\n```python\nc\n```\n";
        assert_eq!(first_python(page), Some("import a\na.b()"));
        assert_eq!(first_python("nothing"), None);
    }
}
