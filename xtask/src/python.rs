//! Python: the example, the package and the paper, each in a virtual environment.
//!
//! The package is installed into a fresh environment as a user does, where the README's quick start
//! runs; then its tests, the examples in its documentation, and checks of types and style.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{program, read, root, run, run_counted, succeeds, target, with},
    outcome::{Failure, Finding},
};

/// Library of the example.
const LIBRARY: &str = "polars>=1.0,<2";

/// Programs that build the paper, as binaries.
const PAPER: [&str; 2] = ["pypandoc_binary>=1.15,<2", "typst>=0.13,<1"];

/// Scripts of the repository, from the package's folder.
const SCRIPTS: &str = "../../scripts";

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

/// The example reads the results of a small case.
pub(crate) fn example() -> Result<Finding, Failure> {
    let python = match environment("3.9", "python", "import polars", &[LIBRARY]) {
        Ok(python) => python,
        Err(reason) => return Ok(Finding::Skipped(reason)),
    };
    let results = target().join("python-example");
    let mut run_case = program("--bin", "wholestring")?;
    run_case.args(["run", "crates/cli/tests/data/slant.toml", "--quiet", "--overwrite", "-o"]);
    run(run_case.arg(&results), "the example needs its results")?;
    let mut example = Command::new(python);
    example.current_dir(root()).arg("examples/read_results.py").arg(&results);
    run(&mut example, "the example reads the results of a run").map(Finding::from)
}

/// Writes `target/paper/paper.pdf`.
pub(crate) fn paper() -> Result<Finding, Failure> {
    with(environment("3.10", "paper/tools", "import pypandoc, typst", &PAPER), |python| {
        let folder = target().join("paper");
        let mut build = Command::new(python);
        build.current_dir(root()).arg("paper/build.py");
        build.arg(folder.join("paper.typ")).arg(folder.join("paper.pdf"));
        run(&mut build, "the paper must build")
    })
}

/// The package: its quick start, its tests, types and style, and the style of `scripts`.
pub(crate) fn package() -> Result<Finding, Failure> {
    with(test_environment(), |python| {
        quick_start()?;
        install(&python, &["--no-deps", "--force-reinstall"])?;
        let own = python.to_string_lossy();
        let checks: [(&str, &[&str], &str); 4] = [
            ("ruff", &["format", "--check", ".", SCRIPTS], "run `ruff format` in crates/python"),
            ("ruff", &["check", ".", SCRIPTS], "warnings count as errors"),
            ("mypy", &[], "the types must hold"),
            ("pyright", &["--pythonpath", &own], "the types must hold"),
        ];
        for (name, arguments, advice) in checks {
            run(module(&python, name).args(arguments), advice)?;
        }
        run_counted(&mut module(&python, "pytest"))
    })
}

/// The README's quick start, in an environment with only the package and its dependencies.
fn quick_start() -> Result<(), Failure> {
    let readme = read(&root().join("README.md"))?;
    let example = first_python(&readme).ok_or_else(|| Failure::new("README.md shows no Python"))?;
    let folder = target().join("python-fresh");
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(Failure::at(&folder))?;
    }
    let fresh = environment("3.10", "python-fresh", "", &[]).map_err(Failure::new)?;
    install(&fresh, &[])?;
    run(
        Command::new(fresh).current_dir(root()).args(["-c", example]),
        "the quick start in README.md must run unchanged",
    )
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

/// The Python of a virtual environment with the dependencies of the package's tests.
fn test_environment() -> Result<PathBuf, String> {
    let python = environment("3.10", "python-package", "import pip", &[])?;
    let has_all =
        || succeeds(Command::new(&python).current_dir(package_folder()).args(["-c", CHECK]));
    if !has_all() {
        succeeds(module(&python, "pip").args(["install", "--quiet", "--upgrade", PIP]));
        succeeds(module(&python, "pip").args(["install", "--quiet", "--group", "test"]));
    }
    let reason = "the requirements of its tests cannot be installed in a virtual environment here";
    if has_all() { Ok(python) } else { Err(reason.into()) }
}

fn package_folder() -> PathBuf {
    root().join("crates/python")
}

/// A Python module to run in the package's folder.
fn module(python: &Path, name: &str) -> Command {
    let mut command = Command::new(python);
    command.current_dir(package_folder()).args(["-m", name]);
    command
}

/// A Python of at least version `oldest`, such as 3.9, to run in the root of the repository.
pub(crate) fn python(oldest: &str) -> Result<Command, String> {
    let check = format!("import sys; sys.exit(sys.version_info < ({}))", oldest.replace('.', ", "));
    let command = |words: &&[&str]| {
        let mut command = Command::new(words[0]);
        command.current_dir(root()).args(&words[1..]);
        command
    };
    let names = [&["python3"][..], &["python"], &["py", "-3"]];
    let found = names.iter().find(|words| succeeds(command(words).args(["-c", &check])));
    found.map(command).ok_or_else(|| format!("there is no Python {oldest} or newer here"))
}

/// The Python of a virtual environment in a folder of builds in which `check` runs, with these
/// arguments of `pip install`; created once and kept.
pub(crate) fn environment(
    oldest: &str,
    name: &str,
    check: &str,
    install: &[&str],
) -> Result<PathBuf, String> {
    let folder = target().join(name);
    let inside = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let is_complete = || succeeds(Command::new(&inside).current_dir(root()).args(["-c", check]));
    if !is_complete() {
        succeeds(python(oldest)?.args(["-m", "venv"]).arg(folder));
        let mut pip = Command::new(&inside);
        pip.current_dir(root()).args(["-m", "pip", "install", "--quiet"]).args(install);
        succeeds(&mut pip);
    }
    let reason = || {
        format!("`{}` cannot be installed in a virtual environment here", install.join("` and `"))
    };
    if is_complete() { Ok(inside) } else { Err(reason()) }
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
