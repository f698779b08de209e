//! Circles between files: one uses an item that another declares, and that one, through others,
//! uses an item of the first.
//!
//! Paths are followed, through imports and re-exports to the file that declares the item, and
//! macros. Methods of values are not, because this requires a compiler. A module that only
//! re-exports its children's items does not use them. Code compiled only for tests does not count.

mod circles;
mod modules;
#[cfg(test)]
mod tests;
pub(crate) mod tokens;

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use circles::{Circle, circles};
use modules::Modules;

/// The circles of each crate of a repository, in words; empty if there are none.
///
/// # Errors
///
/// If a source cannot be read.
pub fn in_words(root: &Path) -> io::Result<String> {
    let mut text = String::new();
    for file in crate_roots(root)? {
        let modules = Modules::read(&file).map_err(|error| {
            io::Error::new(error.kind(), format!("{}: {error}", file.display()))
        })?;
        let arrows = modules.arrows();
        let folder = file.parent().unwrap_or(root);
        let name = |index: usize| {
            let file = &modules.files[index];
            file.strip_prefix(folder).unwrap_or(file).display().to_string()
        };
        for Circle { knot, chains } in circles(modules.files.len(), &arrows) {
            let path = file.strip_prefix(root).unwrap_or(&file).display();
            text += &format!("{path}: {} files in circles\n", knot.len());
            for chain in &chains {
                text += &format!("    {}", name(chain[0]));
                for (i, &from) in chain.iter().enumerate() {
                    let to = chain[(i + 1) % chain.len()];
                    let names = &arrows[&(from, to)];
                    let mut tied: Vec<_> = names.iter().take(4).map(String::as_str).collect();
                    if names.len() > tied.len() {
                        tied.push("...");
                    }
                    text += &format!(" -[{}]-> {}", tied.join(", "), name(to));
                }
                text.push('\n');
            }
        }
    }
    Ok(text)
}

/// The root files of the crates in `crates/` and of `xtask`: library, program and further programs.
fn crate_roots(root: &Path) -> io::Result<Vec<PathBuf>> {
    let mut packages = folder(&root.join("crates"))?;
    packages.push(root.join("xtask"));
    let mut roots = Vec::new();
    for package in packages {
        let source = package.join("src");
        roots.extend([source.join("lib.rs"), source.join("main.rs")]);
        roots.extend(folder(&source.join("bin"))?);
    }
    roots.retain(|file| file.is_file());
    Ok(roots)
}

/// Contents of a folder, by name; empty if it does not exist.
fn folder(path: &Path) -> io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(Vec::new());
    }
    let entries: io::Result<Vec<_>> = fs::read_dir(path)?.collect();
    let mut paths: Vec<_> = entries?.iter().map(fs::DirEntry::path).collect();
    paths.sort();
    Ok(paths)
}
