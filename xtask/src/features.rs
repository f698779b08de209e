//! Features with which the Python package is compiled. It is compiled alone, and cargo gives a
//! shared package the union of the features that a command needs: if these differ from those in the
//! tests of the workspace, all dependent packages are compiled a second time.

use std::collections::BTreeSet;

use crate::{
    command::{Failure, WORKSPACE, cargo, printed},
    finding::Finding,
};

/// Each package has the features with which the tests compile it.
pub(crate) fn check() -> Result<Finding, Failure> {
    let tested = packages(&[&WORKSPACE[..], &["--edges", "normal,build,dev"]].concat())?;
    let alone = packages(&["--package", "wholestring-python", "--edges", "normal,build"])?;
    let apart: Vec<&str> = alone.difference(&tested).map(String::as_str).collect();
    match apart.is_empty() {
        true => Ok(Finding::Done),
        false => Err(Failure::new(format!(
            "the Python package alone needs builds that the tests do not have; enable the \
             features that `cargo tree -i` shows in crates/python/Cargo.toml:\n  {}",
            apart.join("\n  ")
        ))),
    }
}

/// Name, version and features of all packages in the build of these.
fn packages(chosen: &[&str]) -> Result<BTreeSet<String>, Failure> {
    let mut command = cargo();
    command.args(["tree", "--locked", "--prefix", "none", "--format", "{p} [{f}]"]).args(chosen);
    let text = printed(&mut command, "is Cargo.lock up to date?")?;
    // Packages shown before are marked.
    Ok(text.lines().map(|line| line.trim_end_matches(" (*)").to_owned()).collect())
}
