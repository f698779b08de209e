//! Cargo's metadata of the workspace.

use serde_json::Value;

use crate::command::{Failure, cargo, printed};

/// All packages and their dependencies, as in the lock file.
pub(crate) fn all() -> Result<Value, Failure> {
    asked(&["--all-features"])
}

/// The members of the workspace alone: their manifests.
pub(crate) fn of_members() -> Result<Value, Failure> {
    asked(&["--no-deps"])
}

fn asked(more: &[&str]) -> Result<Value, Failure> {
    let mut command = cargo();
    command.args(["metadata", "--format-version", "1", "--locked"]).args(more);
    serde_json::from_str(&printed(&mut command, "is Cargo.lock up to date?")?)
        .map_err(|error| Failure::new(format!("`cargo metadata`: {error}")))
}

/// Elements of a list; none for other values.
pub(crate) fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

/// A text; empty for other values.
pub(crate) fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}
