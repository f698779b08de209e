//! A copy of the tracked files, to change and compile.

use std::{
    collections::BTreeSet,
    fs, io,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, cargo},
    folders::{root, target},
};

/// The copy, kept from one patch to the next with its build, so that only the parts that a patch
/// touches are compiled again.
pub(super) struct Tree {
    folder: PathBuf,
}

impl Tree {
    pub(super) fn new() -> Self {
        Self { folder: target().join("changes") }
    }

    fn sources(&self) -> PathBuf {
        self.folder.join("sources")
    }

    /// Restores it to the state of the working tree by writing only the differences.
    pub(super) fn restore(&self) -> Result<(), Failure> {
        let files = tracked()?;
        let failed = |error: io::Error| {
            Failure::new(format!("a copy of the sources in {}: {error}", self.folder.display()))
        };
        copy(&root(), &self.sources(), &files).map_err(failed)
    }

    /// A program that runs in it.
    pub(super) fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        command.current_dir(self.sources());
        // Git treats the folder as separate, not as part of the repository around it.
        command.env("GIT_CEILING_DIRECTORIES", &self.folder);
        command
    }

    /// Cargo in it. It builds into a folder of its own: cargo identifies crates by their path in
    /// the workspace, and would otherwise use the builds of this copy for the sources themselves.
    pub(super) fn cargo(&self) -> Command {
        let mut command = cargo();
        command.current_dir(self.sources());
        command.env("CARGO_TARGET_DIR", self.folder.join("target"));
        command
    }
}

/// The files that git tracks or would track, from the root.
fn tracked() -> Result<BTreeSet<PathBuf>, Failure> {
    let mut git = Command::new("git");
    git.current_dir(root());
    git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
    let output = git.output();
    let output = output.map_err(|error| Failure::new(format!("git cannot be started: {error}")))?;
    if !output.status.success() {
        return Err(Failure::new("git does not list the files of the repository"));
    }
    let names = String::from_utf8_lossy(&output.stdout).into_owned();
    let names = names.split('\0').filter(|name| !name.is_empty()).map(PathBuf::from);
    Ok(names.filter(|name| root().join(name).is_file()).collect())
}

/// Makes `to` contain these files of `from`, and no others. Equal files keep their time.
pub(super) fn copy(from: &Path, to: &Path, files: &BTreeSet<PathBuf>) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for name in files {
        let (source, copy) = (from.join(name), to.join(name));
        let bytes = fs::read(source)?;
        if fs::read(&copy).ok().as_ref() != Some(&bytes) {
            fs::create_dir_all(copy.parent().unwrap_or(to))?;
            fs::write(copy, bytes)?;
        }
    }
    remove_others(to, to, files)
}

/// Removes the files of a folder of `top` that are not among these, and empty folders.
fn remove_others(folder: &Path, top: &Path, files: &BTreeSet<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            remove_others(&path, top, files)?;
            if fs::read_dir(&path)?.next().is_none() {
                fs::remove_dir(path)?;
            }
        } else if path.strip_prefix(top).is_ok_and(|name| !files.contains(name)) {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}
