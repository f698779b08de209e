//! Examples of changes: patches in `docs/changes`, each of which adds one thing of a kind, and the
//! table of `CONTRIBUTING.md` with the number of files that such a change touches.
//!
//! The numbers in the table and in the patches are always compared. On demand, the patches are
//! applied, compiled and tested, because a patch becomes outdated with every edit of its context.

mod patch;
mod places;
mod table;
#[cfg(test)]
mod tests;
mod tree;

use std::{ffi::OsStr, fs, process::Command};

use crate::{
    command::{Failure, WORKSPACE, run, run_counted},
    count::Count,
    finding::Finding,
    folders::root,
};

use patch::Patch;
use places::{PATCHES, TABLE};
use tree::Tree;

/// Lines around a change in a patch: few, so that it remains valid longer.
const CONTEXT: &str = "-U2";

/// Every row of the table has the number of files that its patch changes, and every patch has a
/// row.
pub(crate) fn check_table() -> Result<Finding, Failure> {
    compare(&patches()?)?;
    Ok(Finding::Done)
}

/// Applies each patch, or the named one, to a copy of the tracked files, compiles everything there,
/// and on request runs the tests that its head names.
pub(crate) fn try_out(only: Option<&str>, with_tests: bool) -> Result<Finding, Failure> {
    let mut patches = patches()?;
    compare(&patches)?;
    if let Some(only) = only {
        patches = vec![find(patches, only)?];
    }
    let tree = Tree::new();
    let mut count = Count::default();
    for (number, patch) in patches.iter().enumerate() {
        let (file, files) = (patch.file(), patch.by_hand().len());
        println!("[{}/{}] {file}: {files} files by hand", number + 1, patches.len());
        tree.restore()?;
        run(
            tree.command("git").args(["apply", "--whitespace=nowarn"]).arg(root().join(&file)),
            &format!(
                "{file} does not apply any more: `git apply -3 {file}`, resolve the conflicts, \
                 `cargo xtask changes --record {}`, and restore the sources",
                patch.name
            ),
        )?;
        run(
            tree.cargo().args(["check", "--quiet", "--all-targets"]).args(WORKSPACE),
            &format!("the result of {file} must compile: fix the patch"),
        )?;
        if with_tests {
            for test in patch.tests() {
                let mut runner = tree.cargo();
                runner.args(["test", "--quiet"]).args(WORKSPACE).args(test.split_whitespace());
                let ran = run_counted(&mut runner)?;
                if ran.passed == 0 {
                    return Err(Failure::new(format!(
                        "{file} names tests that are not there: {test}"
                    )));
                }
                count += ran;
            }
        }
    }
    tree.restore()?;
    if with_tests {
        println!("{count}");
    }
    Ok(Finding::Tested(count))
}

/// Writes the changes of the working tree as the patch of a name, under its existing head.
pub(crate) fn record(name: &str) -> Result<Finding, Failure> {
    let patch = find(patches()?, name)?;
    let git = |arguments: &[&OsStr]| {
        let output = Command::new("git").current_dir(root()).args(arguments).output();
        output.map_err(|error| Failure::new(format!("git cannot be started: {error}")))
    };
    // New files are included.
    git(&["add", "--all", "--intent-to-add"].map(OsStr::new))?;
    let exclude = format!(":!{PATCHES}");
    let arguments = ["diff", "--abbrev=12", CONTEXT, "HEAD", "--", ".", &exclude];
    let output = git(&arguments.map(OsStr::new))?;
    if !output.status.success() || output.stdout.is_empty() {
        return Err(Failure::new("the working tree changes nothing that could be a patch"));
    }
    let text = patch.head + &String::from_utf8_lossy(&output.stdout);
    let path = root().join(PATCHES).join(format!("{name}.patch"));
    fs::write(&path, text).map_err(|error| Failure::new(format!("{}: {error}", path.display())))?;
    Ok(Finding::Done)
}

fn patches() -> Result<Vec<Patch>, Failure> {
    Patch::all_in(&root().join(PATCHES))
        .map_err(|error| Failure::new(format!("{PATCHES}: {error}")))
}

fn find(patches: Vec<Patch>, name: &str) -> Result<Patch, Failure> {
    let known: Vec<String> = patches.iter().map(|patch| patch.name.clone()).collect();
    let found = patches.into_iter().find(|patch| patch.name == name);
    let known = known.join(", ");
    found.ok_or_else(|| Failure::new(format!("`{name}` is not a patch; the patches are {known}")))
}

fn compare(patches: &[Patch]) -> Result<(), Failure> {
    let text = fs::read_to_string(root().join(TABLE))
        .map_err(|error| Failure::new(format!("{TABLE}: {error}")))?;
    let faults = table::faults(&text, patches);
    if faults.is_empty() { Ok(()) } else { Err(Failure::new(faults.join("\n"))) }
}
