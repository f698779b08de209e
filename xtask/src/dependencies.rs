//! The book's table of dependencies: every direct one of a crate or a page, its licence, its users,
//! and its purpose. Names, licences and users come from the manifests; the purpose is written by
//! hand.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::Write as _,
    path::PathBuf,
};

use serde_json::Value;

use crate::{
    book,
    command::{read, root},
    crates::{list, metadata, text},
    outcome::{Failure, Finding},
};

const COMMAND: &str = "dependencies --write";

/// Folders of pages' sources; npm's lock file contains the licences.
const PAGES: [&str; 2] = ["crates/report/web", "web/app"];

/// Licence and users of a dependency, with whether a user needs it only for tests.
type Dependency = (String, BTreeMap<String, bool>);

fn page() -> PathBuf {
    root().join("docs/src/dependencies.md")
}

/// The table has each dependency with its purpose, and no former one.
pub(crate) fn check_table() -> Result<Finding, Failure> {
    let table = written()?;
    if let Some(row) = table.lines().find(|row| row.ends_with(" |  |")) {
        return Err(Failure::new(format!("docs/src/dependencies.md, {row}: give the purpose")));
    }
    book::check(&page(), COMMAND, &table)
}

/// Writes the table into the book; the purpose of each dependency is kept.
pub(crate) fn write_table() -> Result<Finding, Failure> {
    let table = written()?;
    for row in table.lines().filter(|row| row.ends_with(" |  |")) {
        println!("give the purpose in docs/src/dependencies.md: {row}");
    }
    book::write(&page(), COMMAND, &table)
}

/// The table with the purposes that the page has.
fn written() -> Result<String, Failure> {
    let parsed = |path: String| {
        let text = read(&root().join(&path))?;
        serde_json::from_str(&text).map_err(|error| Failure::new(format!("{path}: {error}")))
    };
    let mut all = of_crates(&metadata(&["--all-features"])?);
    for page in PAGES {
        let manifest = parsed(format!("{page}/package.json"))?;
        of_page(page, &manifest, &parsed(format!("{page}/package-lock.json"))?, &mut all);
    }
    let page = read(&page())?;
    Ok(table(&all, &purposes(book::parts(&page, COMMAND)?[1])))
}

/// External dependencies of the workspace's members.
fn of_crates(metadata: &Value) -> BTreeMap<String, Dependency> {
    let packages: BTreeMap<&str, &Value> =
        list(&metadata["packages"]).map(|package| (text(&package["id"]), package)).collect();
    let members: BTreeSet<&str> = list(&metadata["workspace_members"]).map(text).collect();
    let mut found: BTreeMap<(&str, &str), Dependency> = BTreeMap::new();
    for node in list(&metadata["resolve"]["nodes"]) {
        let Some(user) = members.get(text(&node["id"])).and_then(|id| packages.get(id)) else {
            continue;
        };
        for used in list(&node["deps"]).filter(|used| !members.contains(text(&used["pkg"]))) {
            let Some(package) = packages.get(text(&used["pkg"])) else { continue };
            let key = (text(&package["name"]), text(&package["version"]));
            let (licence, users) = found.entry(key).or_default();
            // The old notation of alternatives.
            *licence = text(&package["license"]).replace('/', " OR ");
            let for_tests = list(&used["dep_kinds"]).all(|kind| kind["kind"] == "dev");
            *users.entry(text(&user["name"]).to_owned()).or_insert(true) &= for_tests;
        }
    }
    let names: Vec<&str> = found.keys().map(|(name, _)| *name).collect();
    let named = |((name, version), dependency): ((&str, &str), Dependency)| {
        let is_one = names.iter().filter(|other| **other == name).count() == 1;
        (if is_one { name.to_owned() } else { format!("{name} {version}") }, dependency)
    };
    found.into_iter().map(named).collect()
}

/// Dependencies of a page and of its build. The two kinds in npm are not distinguished, because all
/// of them are bundled or make the bundle.
fn of_page(page: &str, manifest: &Value, lock: &Value, all: &mut BTreeMap<String, Dependency>) {
    for part in ["dependencies", "devDependencies"] {
        for (name, _) in manifest[part].as_object().into_iter().flatten() {
            let (licence, users) = all.entry(format!("{name} (npm)")).or_default();
            let package = &lock["packages"][format!("node_modules/{name}")];
            *licence = text(&package["license"]).to_owned();
            users.insert(page.to_owned(), false);
        }
    }
}

/// Purposes of the dependencies, from the table.
fn purposes(table: &str) -> BTreeMap<&str, &str> {
    let rows = table.lines().filter_map(|line| {
        let (name, rest) = line.strip_prefix("| `")?.split_once("` |")?;
        let purpose = rest.splitn(3, " | ").nth(2)?;
        Some((name, purpose.trim_end_matches('|').trim()))
    });
    rows.collect()
}

fn table(all: &BTreeMap<String, Dependency>, purposes: &BTreeMap<&str, &str>) -> String {
    let mut table =
        String::from("| dependency | licence | used by | purpose |\n|---|---|---|---|\n");
    for (name, (licence, users)) in all {
        let users_for = |tests: bool| {
            let users = users.iter().filter(|(_, for_tests)| **for_tests == tests);
            let short = |user: &String| user.trim_start_matches("wholestring-").to_owned();
            users.map(|(user, _)| short(user)).collect::<Vec<_>>().join(", ")
        };
        let (mut used, tests) = (users_for(false), users_for(true));
        if !tests.is_empty() {
            used += if used.is_empty() { "tests of " } else { "; tests of " };
            used += &tests;
        }
        let purpose = purposes.get(name.as_str()).unwrap_or(&"");
        let _ = writeln!(table, "| `{name}` | {licence} | {used} | {purpose} |");
    }
    table
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn direct_dependencies_are_listed_with_their_users() {
        let mut all = of_crates(&json!({
            "workspace_members": ["ours", "more"],
            "packages": [
                { "id": "ours", "name": "wholestring-ours", "version": "0.1.0" },
                { "id": "more", "name": "wholestring", "version": "0.1.0" },
                { "id": "a1", "name": "a", "version": "1.0.0", "license": "MIT/Apache-2.0" },
                { "id": "b1", "name": "b", "version": "1.0.0", "license": "MIT" },
                { "id": "b2", "name": "b", "version": "2.0.0", "license": "MIT" },
                { "id": "c1", "name": "c", "version": "1.0.0", "license": "MIT" },
            ],
            "resolve": { "nodes": [
                { "id": "ours", "deps": [
                    { "pkg": "more", "dep_kinds": [{ "kind": null }] },
                    { "pkg": "a1", "dep_kinds": [{ "kind": "dev" }] },
                    { "pkg": "b1", "dep_kinds": [{ "kind": null }, { "kind": "dev" }] },
                ]},
                { "id": "more", "deps": [
                    { "pkg": "a1", "dep_kinds": [{ "kind": null }] },
                    { "pkg": "b2", "dep_kinds": [{ "kind": null }] },
                ]},
                { "id": "a1", "deps": [{ "pkg": "c1", "dep_kinds": [{ "kind": null }] }] },
            ]},
        }));
        let manifest = json!({ "devDependencies": { "z": "1.0.0" } });
        let lock = json!({ "packages": { "node_modules/z": { "license": "ISC" } } });
        of_page("web", &manifest, &lock, &mut all);
        let old = "| `a` | MIT | x | kept |\n| `gone` | MIT | x | gone |\n";
        let expected = "\
| dependency | licence | used by | purpose |
|---|---|---|---|
| `a` | MIT OR Apache-2.0 | wholestring; tests of ours | kept |
| `b 1.0.0` | MIT | ours |  |
| `b 2.0.0` | MIT | wholestring |  |
| `z (npm)` | ISC | web |  |
";
        assert_eq!(table(&all, &purposes(old)), expected);
    }
}
