//! Dependencies between the crates.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

use crate::metadata::{list, text};

/// The crates that each crate uses.
pub(super) type Uses = BTreeMap<String, BTreeSet<String>>;

/// Dependencies between the crates of the project, except for tests.
pub(super) fn of_crates(metadata: &Value) -> Uses {
    let ours = |package: &&Value| {
        package["source"].is_null() && text(&package["name"]).starts_with("wholestring")
    };
    let packages: Vec<&Value> = list(&metadata["packages"]).filter(ours).collect();
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

/// Removes indirect dependencies: that of `a` on `c` if `a` uses `b` and `b` uses `c`.
pub(super) fn direct(uses: &Uses) -> Uses {
    let mut direct = uses.clone();
    for used in direct.values_mut() {
        let by_others: BTreeSet<String> =
            used.iter().flat_map(|name| reached(uses, name)).collect();
        used.retain(|name| !by_others.contains(name));
    }
    direct
}

/// All crates that a crate uses, directly and through others.
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
