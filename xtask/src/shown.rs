//! Commands in the README and the book's first pages, run unchanged one after the other in a fresh
//! folder with the shipped cases.

use std::{env, fs, io, path::Path, process::Command};

use crate::{
    command::{copy, program, read, root, succeeds, target},
    outcome::{Failure, Finding},
};

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

/// Folder of files of the reader's own.
const SAMPLES: &str = "crates/import/tests/samples/own";

/// Other folders and files that these pages assume.
const ASSUMED: [(&str, &str); 4] = [
    ("cases", "cases"),
    ("studies", "studies"),
    (SAMPLES, SAMPLES),
    ("crates/cli/tests/data/survey.csv", "my-survey.csv"),
];

/// Files of the reader's own, and their names on the pages.
const OWN: [(&str, &str); 9] = [
    ("survey-wellpath-report.txt", "survey.txt"),
    ("tally.csv", "bha7.csv"),
    ("witsml-trajectory.xml", "trajectory.xml"),
    ("witsml-tubular.xml", "tubular.xml"),
    ("witsml-wbgeometry.xml", "wbgeometry.xml"),
    ("witsml-bharun.xml", "bharun.xml"),
    ("edm-well.xml", "well.edm.xml"),
    ("surface-log.las", "trip.las"),
    ("surface-log.las", "rig.las"),
];

/// Programs whose lines are commands; other indented text is not.
const PROGRAMS: [&str; 6] = ["cargo", "wholestring", "git", "cd", "cp", "pip"];

/// Beginning of the text with which a page presents a file: the name is in backquotes.
const SAVE: &str = "Save this as `";

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

/// Files whose commands take minutes, and what is run instead unless all are requested. A study
/// without its cases has no check.
const MINUTES: [(&str, &str); 2] = [
    ("cases/rock-300.toml", "wholestring check cases/rock-300.toml"),
    ("studies/full-hole-system-dynamics.toml", "test -f studies/full-hole-system-dynamics.toml"),
];

/// A part of a page, in order.
#[derive(Debug, PartialEq)]
enum Part<'a> {
    /// A line for a shell.
    Command(&'a str),
    /// A file to save under a name.
    File(&'a str, &'a str),
}

/// All commands except those that take minutes.
pub(crate) fn quick() -> Result<Finding, Failure> {
    run_pages(false)
}

/// All commands.
pub(crate) fn all() -> Result<Finding, Failure> {
    run_pages(true)
}

fn run_pages(minutes: bool) -> Result<Finding, Failure> {
    // The commands are written for a shell: quotes, and names with a star.
    if !succeeds(Command::new("sh").args(["-c", "true"])) {
        return Ok(Finding::Skipped("there is no shell `sh` here".into()));
    }
    let built = program("--bin", "wholestring")?;
    let mut path = vec![Path::new(built.get_program()).with_file_name("")];
    path.extend(env::split_paths(&env::var_os("PATH").unwrap_or_default()));
    let path = env::join_paths(path).map_err(|error| Failure::new(error.to_string()))?;
    for page in PAGES {
        let text = read(&root().join(page))?;
        let desk = target().join("shown");
        prepare(&desk).map_err(Failure::at(&desk))?;
        for part in parts(&text) {
            let line = match part {
                Part::File(name, content) => {
                    fs::write(desk.join(name), content).map_err(Failure::at(Path::new(name)))?;
                    continue;
                }
                Part::Command(line) => line.replace(CARGO, "wholestring "),
            };
            if ELSEWHERE.iter().any(|begin| line.starts_with(begin)) {
                continue;
            }
            let long = MINUTES.iter().find(|(file, _)| !minutes && line.contains(file));
            let mut shell = Command::new("sh");
            shell.current_dir(&desk).env("PATH", &path);
            shell.args(["-c", long.map_or(&line, |(_, quick)| quick)]);
            let output = shell.output().map_err(Failure::at(Path::new("sh")))?;
            if !output.status.success() {
                let errors = String::from_utf8_lossy(&output.stderr);
                let reason = format!("{page} shows `{line}`: {}\n{errors}", output.status);
                return Err(Failure::new(reason));
            }
        }
    }
    Ok(Finding::Done)
}

/// Makes a fresh folder with the files that the pages assume.
fn prepare(desk: &Path) -> io::Result<()> {
    if desk.exists() {
        fs::remove_dir_all(desk)?;
    }
    fs::create_dir_all(desk)?;
    for (from, to) in ASSUMED {
        copy(&root().join(from), &desk.join(to))?;
    }
    for (from, to) in OWN {
        copy(&root().join(SAMPLES).join(from), &desk.join(to))?;
    }
    Ok(())
}

/// The commands of a page, indented or in a shell block, and the files to save.
fn parts(page: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut saved = None;
    let mut fence: Option<(&str, usize)> = None;
    let mut end = 0;
    for line in page.split_inclusive('\n') {
        let begin = end;
        end += line.len();
        let word = line.trim_end();
        if let Some(language) = word.strip_prefix("```") {
            if let (Some((_, content)), Some(name)) = (fence, saved) {
                parts.push(Part::File(name, &page[content..begin]));
                saved = None;
            }
            fence = if fence.is_none() { Some((language, end)) } else { None };
            continue;
        }
        let command = match fence {
            Some((language, _)) => (language == "sh").then_some(word),
            None => word.strip_prefix("    "),
        };
        let is_command =
            |line: &&str| PROGRAMS.iter().any(|program| line.split(' ').next() == Some(program));
        parts.extend(command.filter(is_command).map(Part::Command));
        if let (None, Some((_, rest))) = (fence, line.split_once(SAVE)) {
            saved = rest.split_once('`').map(|(name, _)| name);
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_and_files_come_in_order() {
        let page = "\
Try\n\n    wholestring check a.toml\n    12 kN\n\nSave this as `b.toml`:\n\n```toml\nx = 1\n```\n
```sh\nwholestring run b.toml\n```\n\n```text\nwholestring says nothing\n```\n";
        assert_eq!(
            parts(page),
            [
                Part::Command("wholestring check a.toml"),
                Part::File("b.toml", "x = 1\n"),
                Part::Command("wholestring run b.toml"),
            ]
        );
    }
}
