//! Equations of the book in the documentation of the code. The book contains them; those that a doc
//! comment shows are converted to files of the crate, which the comment includes.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

use super::{
    equations::{Part, parts},
    tree::{files, pages, relative},
};
use crate::{command::Failure, finding::Finding, folders::root};

/// Folder of a crate's equations.
const FOLDER: &str = "equations";

/// Text in a doc comment before the name of the equation's file.
const INCLUDED: &str = "include_str!(\"";

/// Rustdoc has no style for equations: they have their natural width, and scroll on a narrow
/// screen.
const STYLE: &str = "margin: 0.4em 0 0.8em; padding: 0.4em 0; overflow: auto hidden";

/// Each file of a crate's equations equals the one made from the book.
pub(crate) fn check() -> Result<Finding, Failure> {
    let expected = wanted()?;
    let there = there()?;
    let advice = "run `cargo xtask equations --write`";
    for (path, text) in &expected {
        if there.get(path) != Some(text) {
            let reason =
                format!("{} differs from the one made from the book; {advice}", path.display());
            return Err(Failure::new(reason));
        }
    }
    match there.keys().find(|path| !expected.contains_key(*path)) {
        Some(path) => Err(Failure::new(format!("{} is not used; {advice}", path.display()))),
        None => Ok(Finding::Done),
    }
}

/// Writes them, and removes unused ones.
pub(crate) fn write() -> Result<Finding, Failure> {
    let expected = wanted()?;
    let cannot = |path: &Path, error| Failure::new(format!("{}: {error}", path.display()));
    for path in there()?.keys().filter(|path| !expected.contains_key(*path)) {
        fs::remove_file(path).map_err(|error| cannot(path, error))?;
    }
    for (path, text) in &expected {
        let folder = path.parent().unwrap_or(path);
        fs::create_dir_all(folder).map_err(|error| cannot(folder, error))?;
        fs::write(path, text).map_err(|error| cannot(path, error))?;
    }
    println!("{} equations of the book in the documentation of the code", expected.len());
    Ok(Finding::Done)
}

/// The existing files.
fn there() -> Result<BTreeMap<PathBuf, String>, Failure> {
    let mut there = BTreeMap::new();
    for (path, text) in files(&root().join("crates"), "html")? {
        let folder = path.parent();
        let package = folder.and_then(Path::parent).and_then(Path::parent);
        let ours = folder.is_some_and(|folder| folder.ends_with(FOLDER));
        if ours && package == Some(&root().join("crates")) {
            there.insert(path, text);
        }
    }
    Ok(there)
}

/// The required files: one for each equation with a name, in the one crate that shows it.
fn wanted() -> Result<BTreeMap<PathBuf, String>, Failure> {
    let mut named = BTreeMap::new();
    for (path, page) in pages()? {
        let place = path.strip_prefix(root()).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        for (name, text) in of_page(&page, &place).map_err(Failure::new)? {
            if named.insert(name.clone(), text).is_some() {
                return Err(Failure::new(format!("two equations of the book are named {name}")));
            }
        }
    }
    let mut expected = BTreeMap::new();
    let mut places = BTreeMap::new();
    for (path, source) in files(&root().join("crates"), "rs")? {
        for include in includes(&source) {
            let file = relative(&path, include);
            let Some(name) = name(&file) else { continue };
            let place = path.display();
            let Some(text) = named.get(name) else {
                let reason = format!("{place}: the book has no equation named {name}");
                return Err(Failure::new(reason));
            };
            if let Some(other) = places.insert(name.to_owned(), place.to_string()) {
                let reason = format!("{name} is shown twice: in {other} and in {place}");
                return Err(Failure::new(reason));
            }
            expected.insert(file, text.clone());
        }
    }
    match named.keys().find(|name| !places.contains_key(*name)) {
        Some(name) => {
            let reason = "no doc comment shows it, and it needs no name";
            Err(Failure::new(format!("the book's equation {name}: {reason}")))
        }
        None => Ok(expected),
    }
}

/// Names of a page's equations, and the included text of each.
fn of_page(page: &str, place: &str) -> Result<Vec<(String, String)>, String> {
    let mut found = Vec::new();
    for part in parts(page).map_err(|error| format!("{place}, {error}"))? {
        let Part::Equation(equation) = part else { continue };
        let Some(name) = equation.name else { continue };
        let math = equation.set(true).map_err(|error| format!("{place}, {error}"))?;
        // Rows with the same spacing and size as in the book.
        let math = math
            .replace("<math ", "<math style=\"min-width: max-content\" ")
            .replace("<mtable ", "<mtable style=\"math-style: normal\" ")
            .replace("<mtd style=\"", "<mtd style=\"padding-block: 0.25em;")
            // It begins on a new line so that it is easy to find in the file.
            .replace("<annotation", "\n<annotation");
        let origin = format!("<!-- {name} of {place}, by `cargo xtask equations --write` -->");
        found.push((name.to_owned(), format!("{origin}\n<div style=\"{STYLE}\">{math}</div>\n")));
    }
    Ok(found)
}

/// The files that a source includes as text.
fn includes(source: &str) -> impl Iterator<Item = &str> {
    source.split(INCLUDED).skip(1).filter_map(|rest| rest.split_once('"')).map(|(file, _)| file)
}

/// The equation's name, if the file is one of a crate's equations.
fn name(file: &Path) -> Option<&str> {
    let ours = file.parent()?.ends_with(FOLDER) && file.extension()? == "html";
    ours.then(|| file.file_stem()?.to_str()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_what_the_book_makes() {
        if let Err(failure) = check() {
            panic!("{}", failure.reason);
        }
    }

    #[test]
    fn equations_with_a_name_hold_their_latex() {
        let page = "$$\nx\n$$\n\n<!-- equation: half -->\n$$\n\\frac12\n$$\n";
        let found = of_page(page, "a.md").unwrap_or_else(|error| panic!("{error}"));
        let [(name, text)] = &found[..] else { panic!("{found:?}") };
        assert_eq!(name, "half");
        assert!(text.contains("<mfrac>") && text.contains("\\frac12</annotation>"), "{text}");
        // An empty line would end the element.
        assert!(!text.contains("\n\n"), "{text}");
    }

    #[test]
    fn an_include_names_its_equation() {
        let source = "#![doc = include_str!(\"../../equations/half.html\")]";
        let path = Path::new("/crates/core/src/rod/element.rs");
        let file = includes(source).map(|file| relative(path, file)).next();
        assert_eq!(file.as_deref(), Some(Path::new("/crates/core/equations/half.html")));
        assert_eq!(file.as_deref().and_then(name), Some("half"));
        assert_eq!(name(Path::new("/crates/core/src/a.html")), None);
    }
}
