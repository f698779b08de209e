//! The crates of the workspace: their picture in `ARCHITECTURE.md`, their packages, and the
//! features with which they are compiled.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::Write as _,
    fs,
    path::Path,
};

use serde_json::Value;

use crate::{
    book,
    command::{WORKSPACE, cargo, files, printed, relative, root, run, target},
    outcome::{Failure, Finding},
};

/// Command that draws the picture.
const PICTURE: &str = "architecture";

/// Macros that include a file in a program.
const INCLUDES: [&str; 3] = ["include!(", "include_bytes!(", "include_str!("];

/// The crates that each crate uses.
type Uses = BTreeMap<String, BTreeSet<String>>;

/// Cargo's metadata of the workspace, with these options.
pub(crate) fn metadata(options: &[&str]) -> Result<Value, Failure> {
    let mut command = cargo();
    command.args(["metadata", "--format-version", "1", "--locked"]).args(options);
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

/// The picture shows the existing crates and their dependencies.
pub(crate) fn check_picture() -> Result<Finding, Failure> {
    book::check(&root().join("ARCHITECTURE.md"), PICTURE, &picture(&metadata(&["--no-deps"])?))
}

/// Draws it.
pub(crate) fn draw() -> Result<Finding, Failure> {
    book::write(&root().join("ARCHITECTURE.md"), PICTURE, &picture(&metadata(&["--no-deps"])?))
}

/// A diagram in Mermaid with an arrow from each crate to those that it uses, except for tests.
/// Arrows that follow from others are left out.
fn picture(metadata: &Value) -> String {
    let short = |name: &str| name.strip_prefix("wholestring-").unwrap_or(name).to_owned();
    let ours = list(&metadata["packages"])
        .filter(|package| text(&package["name"]).starts_with("wholestring"));
    let uses = ours.map(|package| {
        let used = list(&package["dependencies"])
            .filter(|used| used["kind"].is_null() && !used["path"].is_null())
            .map(|used| short(text(&used["name"])));
        (short(text(&package["name"])), used.collect())
    });
    let uses: Uses = uses.collect();
    let mut lines = String::from("```mermaid\nflowchart TD\n");
    for (name, used) in &uses {
        let through: BTreeSet<&String> = used.iter().flat_map(|one| reached(&uses, one)).collect();
        let direct: Vec<&str> =
            used.iter().filter(|one| !through.contains(one)).map(String::as_str).collect();
        let _ = match direct.is_empty() {
            true => writeln!(lines, "    {name}"),
            false => writeln!(lines, "    {name} --> {}", direct.join(" & ")),
        };
    }
    lines + "```\n"
}

/// All crates that a crate uses, directly and through others.
fn reached<'a>(uses: &'a Uses, name: &str) -> BTreeSet<&'a String> {
    let direct = uses.get(name).into_iter().flatten();
    direct.flat_map(|used| [used].into_iter().chain(reached(uses, used))).collect()
}

/// Each published package contains its sources and licences, and has the fields that a registry
/// requires.
pub(crate) fn check_packages() -> Result<Finding, Failure> {
    let found = missing(&metadata(&["--no-deps"])?)?;
    if found.is_empty() { Ok(Finding::Done) } else { Err(Failure::new(found.join("\n"))) }
}

/// Packs the published crates and builds each from its package; nothing is uploaded. The working
/// tree is packed.
pub(crate) fn package() -> Result<Finding, Failure> {
    check_packages()?;
    let mut command = cargo();
    command.args(["publish", "--workspace", "--dry-run", "--locked", "--allow-dirty"]);
    command.arg("--target-dir").arg(target().join("packages"));
    // Each package is compiled again for the packages after it; debug information is not needed.
    command.env("CARGO_PROFILE_DEV_DEBUG", "false");
    run(&mut command, "each package must compile from its own contents and other packages")
        .map(Finding::from)
}

/// Errors of the packages, one line each, that cargo reports only on publication.
fn missing(metadata: &Value) -> Result<Vec<String>, Failure> {
    let mut found = Vec::new();
    let published = list(&metadata["packages"])
        .filter(|package| package["publish"].as_array().is_none_or(|to| !to.is_empty()));
    for package in published {
        let name = text(&package["name"]);
        let folder = Path::new(text(&package["manifest_path"])).parent().unwrap_or(Path::new(""));
        for key in ["description", "license", "repository", "readme"] {
            if text(&package[key]).is_empty() {
                found.push(format!("{name} has no {key}"));
            }
        }
        // The text of MIT must accompany every copy. In a checkout without links, a link is a file
        // with the path of the other.
        for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
            if fs::read(folder.join(licence)).ok() != fs::read(root().join(licence)).ok() {
                found.push(format!("{name} lacks {licence}: make a link to that of the root"));
            }
        }
        let unversioned = list(&package["dependencies"])
            .filter(|used| !used["path"].is_null() && used["req"] == "*" && used["kind"] != "dev");
        found.extend(unversioned.map(|used| {
            format!("{name} names no version of {}, which it needs", text(&used["name"]))
        }));
        for (file, source) in if folder.is_dir() { files(folder, "rs")? } else { Vec::new() } {
            let outside =
                included(&source).filter(|path| !relative(&file, path).starts_with(folder));
            found.extend(outside.map(|path| format!("{} includes {path}", file.display())));
        }
    }
    Ok(found)
}

/// The files that a source includes, as written; of a `concat!` its first text.
fn included(source: &str) -> impl Iterator<Item = &str> {
    let code = source.lines().filter(|line| !line.trim_start().starts_with("//"));
    code.flat_map(|line| INCLUDES.iter().filter_map(|name| line.split_once(name)))
        .filter_map(|(_, rest)| rest.split('"').nth(1))
}

/// Each package has the features with which the tests compile it. The Python package is compiled
/// alone, and cargo gives a shared package the union of the features that a command needs: if these
/// differ, all dependent packages are compiled a second time.
pub(crate) fn check_features() -> Result<Finding, Failure> {
    let packages = |chosen: &[&str]| -> Result<BTreeSet<String>, Failure> {
        let mut command = cargo();
        command.args(["tree", "--locked", "--prefix", "none", "--format", "{p} [{f}]"]);
        let text = printed(command.args(chosen), "is Cargo.lock up to date?")?;
        // Packages shown before are marked.
        Ok(text.lines().map(|line| line.trim_end_matches(" (*)").to_owned()).collect())
    };
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

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn arrows_that_follow_from_others_are_left_out() {
        let package = |name: &str, used: &[&str]| {
            let used = used.iter().map(|name| json!({ "name": name, "path": "", "kind": null }));
            json!({ "name": name, "dependencies": used.collect::<Vec<_>>() })
        };
        let picture = picture(&json!({ "packages": [
            package("wholestring-a", &["wholestring-b", "wholestring", "wholestring-d"]),
            package("wholestring-b", &["wholestring"]),
            package("wholestring", &[]),
            package("wholestring-d", &[]),
            package("another", &["wholestring"]),
        ]}));
        let expected =
            "flowchart TD\n    wholestring\n    a --> b & d\n    b --> wholestring\n    d\n";
        let lines = |text: &str| text.lines().map(str::to_owned).collect::<BTreeSet<_>>();
        assert!(lines(&picture).is_superset(&lines(expected)), "{picture}");
        assert_eq!(picture.lines().count(), lines(expected).len() + 2);
    }

    #[test]
    fn a_package_that_a_registry_would_refuse_is_found() {
        let ours = |publish: Value| {
            json!({ "packages": [{
                "name": "a",
                "publish": publish,
                "manifest_path": "/nowhere/Cargo.toml",
                "description": "a",
                "license": "MIT",
                "repository": "r",
                "dependencies": [{ "name": "b", "path": "/b", "req": "*", "kind": null }],
            }]})
        };
        assert!(missing(&ours(json!([]))).unwrap().is_empty());
        assert_eq!(
            missing(&ours(Value::Null)).unwrap(),
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
        assert_eq!(included(source).collect::<Vec<_>>(), ["../b.txt", "../../c/"]);
        let leads = |path: &str| relative(Path::new("/p/src/a.rs"), path);
        assert_eq!(leads("./b/../../c"), Path::new("/p/c"));
        assert_eq!(leads("../../c/.d"), Path::new("/c/.d"));
    }

    /// Symbols and line numbers are four fifths of a built program. dist always builds the profile
    /// of its name; image and wheels are built elsewhere.
    #[test]
    fn programs_and_packages_of_a_release_are_stripped() {
        let read = |path: &str| std::fs::read_to_string(root().join(path)).unwrap();
        let manifest = read("Cargo.toml");
        let profile = manifest.split("[profile.dist]\n").nth(1).unwrap();
        let profile: Vec<&str> = profile.lines().take_while(|line| !line.is_empty()).collect();
        assert!(profile.contains(&"strip = true") && profile.contains(&"debug = false"));
        assert!(read(".github/workflows/release.yml").contains("dist build --tag="));
        assert!(read("Containerfile").contains("cargo build --locked --profile dist"));
        let wheels = read("crates/python/pyproject.toml");
        let wheels = wheels.split("[tool.maturin]\n").nth(1).unwrap();
        assert!(wheels.split("\n\n").next().unwrap().contains("strip = true"));
    }
}
