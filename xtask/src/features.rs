//! Features that the Python package is compiled with. It is compiled alone, and cargo gives a
//! package that several use the features that all of one command ask for: where those are others
//! than in the tests of the workspace, all that stands on it is compiled a second time.

use std::collections::BTreeSet;

use crate::{
    command::{Failure, WORKSPACE, cargo, printed},
    finding::Finding,
};

/// Each package has the features that the tests compile it with.
pub(crate) fn check() -> Result<Finding, Failure> {
    let tested = packages(&[&WORKSPACE[..], &["--edges", "normal,build,dev"]].concat())?;
    let alone = packages(&["--package", "wholestring-python", "--edges", "normal,build"])?;
    let apart: Vec<&str> = alone.difference(&tested).map(String::as_str).collect();
    match apart.is_empty() {
        true => Ok(Finding::Done),
        false => Err(Failure::new(format!(
            "the Python package alone is compiled of what the tests do not compile; ask for the \
             features that `cargo tree -i` shows in crates/python/Cargo.toml:\n  {}",
            apart.join("\n  ")
        ))),
    }
}

/// Name, version and features of all that these are compiled of.
fn packages(chosen: &[&str]) -> Result<BTreeSet<String>, Failure> {
    let mut command = cargo();
    command.args(["tree", "--locked", "--prefix", "none", "--format", "{p} [{f}]"]).args(chosen);
    let text = printed(&mut command, "is Cargo.lock up to date?")?;
    // It marks those that it has shown before.
    Ok(text.lines().map(|line| line.trim_end_matches(" (*)").to_owned()).collect())
}
