//! The picture of the crates in `ARCHITECTURE.md`: who uses whom, drawn of what cargo knows.

mod drawing;
mod layers;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::PathBuf,
};

use serde_json::Value;

use crate::{
    command::Failure,
    finding::Finding,
    folders::root,
    metadata::{self, list, text},
};

/// Whom each crate uses.
type Uses = BTreeMap<String, BTreeSet<String>>;

fn picture() -> PathBuf {
    root().join("docs/architecture.svg")
}

/// The picture shows the crates that there are, and what they use.
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
    let uses = direct(&of_crates(&metadata::all()?));
    Ok(drawing::svg(&layers::layers(&uses)))
}

/// What the crates under `crates/` use of each other where they are not tested.
fn of_crates(metadata: &Value) -> Uses {
    let ours = |package: &&Value| text(&package["manifest_path"]).replace('\\', "/");
    let packages: Vec<&Value> = list(&metadata["packages"])
        .filter(|package| package["source"].is_null() && ours(package).contains("/crates/"))
        .collect();
    let names: BTreeSet<&str> = packages.iter().map(|package| text(&package["name"])).collect();
    let used = |package: &Value| {
        list(&package["dependencies"])
            .filter(|dependency| dependency["kind"].is_null())
            .map(|dependency| text(&dependency["name"]))
            .filter(|name| names.contains(name))
            .map(str::to_owned)
            .collect()
    };
    packages.iter().map(|package| (text(&package["name"]).to_owned(), used(package))).collect()
}

/// Without what follows from the rest: where `a` uses `b` and `b` uses `c`, that `a` uses `c`.
fn direct(uses: &Uses) -> Uses {
    let mut direct = uses.clone();
    for used in direct.values_mut() {
        let by_others: BTreeSet<String> =
            used.iter().flat_map(|name| reached(uses, name)).collect();
        used.retain(|name| !by_others.contains(name));
    }
    direct
}

/// All that a crate uses, itself and by way of others.
fn reached(uses: &Uses, name: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open = vec![name.to_owned()];
    while let Some(name) = open.pop() {
        for used in uses.get(&name).into_iter().flatten() {
            if found.insert(used.clone()) {
                open.push(used.clone());
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_follows_from_the_rest_is_left_out() {
        let uses = |pairs: &[(&str, &[&str])]| -> Uses {
            let set = |used: &[&str]| used.iter().map(ToString::to_string).collect();
            pairs.iter().map(|(name, used)| (name.to_string(), set(used))).collect()
        };
        let all = uses(&[("a", &["b", "c", "d"]), ("b", &["c"]), ("c", &["d"]), ("d", &[])]);
        assert_eq!(direct(&all), uses(&[("a", &["b"]), ("b", &["c"]), ("c", &["d"]), ("d", &[])]));
    }
}
