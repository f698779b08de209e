//! The book's table of dependencies: every direct one of a crate or a page, its licence, its users,
//! and its purpose. Names, licences and users come from the manifests; the purpose is written by
//! hand.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::Write as _,
    fs,
    path::PathBuf,
};

use serde_json::Value;

use crate::{
    book,
    command::Failure,
    finding::Finding,
    folders::root,
    metadata::{self, list, text},
};

const COMMAND: &str = "dependencies";

/// Folders of pages' sources; npm's lock file contains the licences.
const PAGES: [&str; 2] = ["crates/report/web", "web/app"];

/// A dependency as the manifests know it.
#[derive(Debug, Default, PartialEq)]
struct Dependency {
    licence: String,
    /// Its users, and whether they use it only for tests.
    users: BTreeMap<String, bool>,
}

type Dependencies = BTreeMap<String, Dependency>;

fn page() -> PathBuf {
    root().join("docs/src/dependencies.md")
}

/// The table has each dependency with its purpose, and no former one.
pub(crate) fn check_table() -> Result<Finding, Failure> {
    let text = read(&page())?;
    let [_, written, _] = book::parts(&text, COMMAND)?;
    let reasons = reasons(written);
    let expected = table(&all()?, &reasons);
    let stale = |line: &str| {
        let advice = "run `cargo xtask dependencies --write`, and give the purpose of a new one";
        Failure::new(format!("docs/src/dependencies.md, {line}; {advice}"))
    };
    let there: BTreeSet<&str> = written.lines().filter(|line| !line.is_empty()).collect();
    let needed: BTreeSet<&str> = expected.lines().collect();
    if let Some(line) = needed.difference(&there).next() {
        return Err(stale(&format!("missing: {line}")));
    }
    if let Some(line) = there.difference(&needed).next() {
        return Err(stale(&format!("out of date: {line}")));
    }
    match reasons.iter().find(|(_, reason)| reason.is_empty()) {
        Some((name, _)) => Err(stale(&format!("the purpose of {name} is missing"))),
        None => Ok(Finding::Done),
    }
}

/// Writes the table into the book; the purpose of each dependency is kept.
pub(crate) fn write_table() -> Result<Finding, Failure> {
    let text = read(&page())?;
    let [_, written, _] = book::parts(&text, COMMAND)?;
    let reasons = reasons(written);
    let all = all()?;
    book::write(&page(), COMMAND, &table(&all, &reasons))?;
    for name in all.keys() {
        if reasons.get(name.as_str()).is_none_or(|reason| reason.is_empty()) {
            println!("give the purpose of {name} in docs/src/dependencies.md");
        }
    }
    Ok(Finding::Done)
}

fn read(path: &PathBuf) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|error| Failure::new(format!("{}: {error}", path.display())))
}

fn all() -> Result<Dependencies, Failure> {
    let mut all = of_crates(&metadata::all()?);
    for page in PAGES {
        let manifest = parsed(&format!("{page}/package.json"))?;
        let lock = parsed(&format!("{page}/package-lock.json"))?;
        of_page(page, &manifest, &lock, &mut all);
    }
    Ok(all)
}

fn parsed(path: &str) -> Result<Value, Failure> {
    let text = read(&root().join(path))?;
    serde_json::from_str(&text).map_err(|error| Failure::new(format!("{path}: {error}")))
}

/// External dependencies of the workspace's members.
fn of_crates(metadata: &Value) -> Dependencies {
    let packages: BTreeMap<&str, &Value> =
        list(&metadata["packages"]).map(|package| (text(&package["id"]), package)).collect();
    let members: BTreeSet<&str> = list(&metadata["workspace_members"]).map(text).collect();
    let mut found: BTreeMap<(&str, &str), Dependency> = BTreeMap::new();
    for node in list(&metadata["resolve"]["nodes"]) {
        let user = text(&node["id"]);
        if !members.contains(user) {
            continue;
        }
        for used in list(&node["deps"]) {
            let id = text(&used["pkg"]);
            let Some(package) = packages.get(id).filter(|_| !members.contains(id)) else {
                continue;
            };
            let key = (text(&package["name"]), text(&package["version"]));
            let dependency = found.entry(key).or_default();
            // The old notation of alternatives.
            dependency.licence = text(&package["license"]).replace('/', " OR ");
            let for_tests = list(&used["dep_kinds"]).all(|kind| kind["kind"] == "dev");
            let user = packages.get(user).map_or(user, |user| text(&user["name"]));
            let alone = dependency.users.entry(user.to_owned()).or_insert(true);
            *alone &= for_tests;
        }
    }
    let mut all = Dependencies::new();
    let versions = |name| found.keys().filter(|(other, _)| *other == name).count();
    let named: Vec<String> = found
        .keys()
        .map(|(name, version)| match versions(*name) {
            1 => (*name).to_owned(),
            _ => format!("{name} {version}"),
        })
        .collect();
    all.extend(named.into_iter().zip(found.into_values()));
    all
}

/// Dependencies of a page and of its build. The two kinds in npm are not distinguished, because all
/// of them are bundled or make the bundle.
fn of_page(page: &str, manifest: &Value, lock: &Value, all: &mut Dependencies) {
    for part in ["dependencies", "devDependencies"] {
        let names = manifest[part].as_object().into_iter().flatten();
        for (name, _) in names {
            let licence = &lock["packages"][format!("node_modules/{name}")]["license"];
            let dependency = all.entry(format!("{name} (npm)")).or_default();
            dependency.licence = text(licence).to_owned();
            dependency.users.insert(page.to_owned(), false);
        }
    }
}

/// Purposes of the dependencies, from the table.
fn reasons(table: &str) -> BTreeMap<&str, &str> {
    let rows = table.lines().filter_map(|line| {
        let cells: Vec<&str> = line.strip_prefix("| `")?.split(" | ").collect();
        let [name, .., reason] = cells[..] else {
            return None;
        };
        Some((name.trim_end_matches('`'), reason.trim_end_matches('|').trim()))
    });
    rows.collect()
}

fn table(all: &Dependencies, reasons: &BTreeMap<&str, &str>) -> String {
    let mut table =
        String::from("| dependency | licence | used by | purpose |\n|---|---|---|---|\n");
    for (name, Dependency { licence, users }) in all {
        let short = |user: &str| user.strip_prefix("wholestring-").unwrap_or(user).to_owned();
        let mut used: Vec<String> = Vec::new();
        for for_tests in [false, true] {
            let these = users.iter().filter(|(_, alone)| **alone == for_tests);
            let these: Vec<String> = these.map(|(user, _)| short(user)).collect();
            match (these.is_empty(), for_tests) {
                (true, _) => {}
                (false, false) => used.push(these.join(", ")),
                (false, true) => used.push(format!("tests of {}", these.join(", "))),
            }
        }
        let reason = reasons.get(name.as_str()).unwrap_or(&"");
        let _ = writeln!(table, "| `{name}` | {licence} | {} | {reason} |", used.join("; "));
    }
    table
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn metadata() -> Value {
        json!({
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
        })
    }

    #[test]
    fn what_a_crate_names_itself_is_listed() {
        let mut all = of_crates(&metadata());
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
        assert_eq!(table(&all, &reasons(old)), expected);
    }
}
