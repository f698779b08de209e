//! The picture of the crates in `ARCHITECTURE.md`, drawn from cargo's metadata.

mod drawing;
mod layers;
mod uses;

use std::{fs, path::PathBuf};

use crate::{command::Failure, finding::Finding, folders::root, metadata};

fn picture() -> PathBuf {
    root().join("docs/architecture.svg")
}

/// The picture shows the existing crates and their dependencies.
pub(crate) fn check() -> Result<Finding, Failure> {
    let there = fs::read_to_string(picture()).unwrap_or_default();
    if there == drawn()? {
        return Ok(Finding::Done);
    }
    Err(Failure::new("docs/architecture.svg is out of date; run `cargo xtask architecture`"))
}

/// Draws it.
pub(crate) fn write() -> Result<Finding, Failure> {
    let path = picture();
    fs::write(&path, drawn()?)
        .map_err(|error| Failure::new(format!("{}: {error}", path.display())))?;
    Ok(Finding::Done)
}

fn drawn() -> Result<String, Failure> {
    let uses = uses::direct(&uses::of_crates(&metadata::all()?));
    Ok(drawing::svg(&layers::layers(&uses)))
}
