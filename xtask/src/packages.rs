//! Publication: every crate that is not excluded, in the order of dependencies. Cargo packs them,
//! and builds each from its own package and the packages before it.

use std::{
    collections::BTreeSet,
    fs, io,
    path::{Component, Path, PathBuf},
};

use serde_json::Value;

use crate::{
    command::{Failure, cargo, run},
    cycles::tokens::tokens,
    finding::Finding,
    folders::{root, target},
    metadata::{self, list, text},
};

/// Macros that include a file in a program.
const INCLUDES: [&str; 3] = ["include", "include_bytes", "include_str"];

/// Licence texts in each package: that of MIT must accompany every copy.
const LICENCES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];

/// Each package contains its sources, and the fields that a registry requires.
pub(crate) fn check() -> Result<Finding, Failure> {
    let found = amiss(&metadata::of_members()?);
    let found = found.map_err(|error| Failure::new(format!("the sources: {error}")))?;
    match found.is_empty() {
        true => Ok(Finding::Done),
        false => Err(Failure::new(found.join("\n"))),
    }
}

/// Packs all of them and builds each from its package, as for publication; nothing is uploaded. The
/// working tree is packed.
pub(crate) fn try_all() -> Result<Finding, Failure> {
    check()?;
    let mut command = cargo();
    command.args(["publish", "--workspace", "--dry-run", "--locked", "--allow-dirty"]);
    command.arg("--target-dir").arg(target().join("packages"));
    // Each package is compiled again for the packages after it; debug information is not needed.
    command.env("CARGO_PROFILE_DEV_DEBUG", "false").env("CARGO_INCREMENTAL", "0");
    run(&mut command, "each package must compile from its own contents and other packages")?;
    Ok(Finding::Done)
}

/// The members that are published.
fn published(metadata: &Value) -> Vec<&Value> {
    let is_published =
        |package: &&Value| package["publish"].as_array().is_none_or(|to| !to.is_empty());
    list(&metadata["packages"])
        .filter(|package| package["source"].is_null())
        .filter(is_published)
        .collect()
}

fn folder(package: &Value) -> PathBuf {
    Path::new(text(&package["manifest_path"])).parent().map(Path::to_path_buf).unwrap_or_default()
}

/// Errors of the packages, one line each: files from outside of them, and missing fields or texts
/// that a registry or a reader of it needs.
fn amiss(metadata: &Value) -> io::Result<Vec<String>> {
    let mut found = Vec::new();
    let mut descriptions = BTreeSet::new();
    for package in published(metadata) {
        let (name, folder) = (text(&package["name"]), folder(package));
        for key in ["description", "license", "repository", "readme"] {
            if text(&package[key]).is_empty() {
                found.push(format!("{name} has no {key}"));
            }
        }
        if !descriptions.insert(text(&package["description"])) {
            found.push(format!("{name} has the description of another crate"));
        }
        for licence in LICENCES {
            let ours = fs::read(root().join(licence))?;
            // In a checkout without links, a link is a file with the path of the other.
            if fs::read(folder.join(licence)).ok() != Some(ours) {
                found.push(format!("{name} lacks {licence}: make a link to that of the root"));
            }
        }
        let unversioned = list(&package["dependencies"])
            .filter(|used| !used["path"].is_null() && used["req"] == "*" && used["kind"] != "dev");
        found.extend(unversioned.map(|used| {
            format!("{name} names no version of {}, which it needs", text(&used["name"]))
        }));
        for file in sources(&folder)? {
            let inside = file.strip_prefix(&folder).unwrap_or(&file);
            let outside = included(&fs::read_to_string(&file)?);
            let outside = outside.into_iter().filter(|path| leaves(inside, path));
            found.extend(outside.map(|path| format!("{} includes {path}", file.display())));
        }
    }
    Ok(found)
}

/// The Rust sources in a folder.
fn sources(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    if !folder.is_dir() {
        return Ok(files);
    }
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default();
        if path.is_dir() && name != "target" && name != "node_modules" {
            files.extend(sources(&path)?);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    Ok(files)
}

/// The files that a source includes, as written; those completed by a macro are left out.
fn included(source: &str) -> Vec<String> {
    let words = tokens(source).unwrap_or_default();
    let begins = words.windows(3).enumerate().filter(|(_, words)| {
        INCLUDES.contains(&words[0].as_str()) && words[1] == "!" && words[2] == "("
    });
    let argument = |(at, _): (usize, &[String])| {
        let mut open = 0;
        let within = words[at + 2..].iter().take_while(|word| {
            open += i32::from(*word == "(") - i32::from(*word == ")");
            open > 0
        });
        within.filter_map(|word| word.strip_prefix('"')?.strip_suffix('"')).collect()
    };
    begins.map(argument).collect()
}

/// Whether a path in a file, whose own path is relative to the package, leads out of the package.
fn leaves(file: &Path, path: &str) -> bool {
    let mut depth = file.components().count() as i64 - 1;
    Path::new(path).components().any(|part| {
        match part {
            Component::ParentDir => depth -= 1,
            Component::CurDir => {}
            _ => depth += 1,
        }
        depth < 0
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_package_that_a_registry_would_refuse_is_found() {
        let ours = |name: &str, publish: Value| {
            json!({
                "name": name,
                "source": null,
                "publish": publish,
                "manifest_path": "/nowhere/Cargo.toml",
                "description": "a",
                "license": "MIT",
                "repository": "r",
                "dependencies": [{ "name": "b", "path": "/b", "req": "*", "kind": null }],
            })
        };
        let metadata = json!({ "packages": [ours("a", json!([]))] });
        assert_eq!(amiss(&metadata).unwrap(), Vec::<String>::new());
        let metadata = json!({ "packages": [ours("a", Value::Null)] });
        assert_eq!(
            amiss(&metadata).unwrap(),
            [
                "a has no readme",
                "a lacks LICENSE-APACHE: make a link to that of the root",
                "a lacks LICENSE-MIT: make a link to that of the root",
                "a names no version of b, which it needs",
            ]
        );
    }

    #[test]
    fn a_file_outside_of_the_package_is_found() {
        let source = "const A: &str = include_str!(\"../b.txt\");\n\
            const B: &[u8] = include_bytes!(concat!(\"../../c/\", $name, \".d\"));\n\
            // include_str!(\"../../e\")\n";
        assert_eq!(included(source), ["../b.txt", "../../c/.d"]);
        assert!(!leaves(Path::new("src/a.rs"), "../b.txt"));
        assert!(leaves(Path::new("src/a.rs"), "../../c/.d"));
        assert!(!leaves(Path::new("src/a.rs"), "./b/../../c"));
        assert!(leaves(Path::new("lib.rs"), "../b"));
    }
}
