//! The program and the Python package in a minimal Debian root without Rust: checks that the
//! documented system packages suffice.

use std::{
    fs, io,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, WORKSPACE, cargo, run, succeeds},
    finding::Finding,
    folders::{copy, root, target},
    python::python,
    python_package::{OLDEST, readme_quick_start},
};

/// Releases of Debian that are tested by default.
const SUITES: [&str; 2] = ["stable", "oldstable"];

/// System packages that the wheel requires.
const PACKAGES: &str = "--include=python3,python3-venv,ca-certificates";

/// Files of this machine that are needed to download packages inside: name servers and trusted
/// certificates.
const NETWORK: [&str; 2] = ["etc/resolv.conf", "etc/ssl/certs/ca-certificates.crt"];

/// Folder of the program in the root.
const DESK: &str = "desk";

/// Tests each of the releases of Debian. It takes minutes and requires debootstrap and root rights.
pub(crate) fn try_all(suites: &[&str]) -> Result<Finding, Failure> {
    if !succeeds(Command::new("debootstrap").arg("--version")) {
        return Err(Failure::new("there is no debootstrap here: install Debian's package"));
    }
    let mut build = cargo();
    build.args(["build", "--release", "--bin", "wholestring"]).args(WORKSPACE);
    run(&mut build, "the program must compile")?;
    let wheel = wheel()?;
    for suite in if suites.is_empty() { &SUITES } else { suites } {
        let folder = target().join("clean-root").join(suite);
        made(suite, &folder)?;
        let furnished = furnish(&folder, &wheel);
        furnished.map_err(|error| Failure::new(format!("{}: {error}", folder.display())))?;
        tried(&folder)?;
        println!("{suite}: program and wheel run");
    }
    Ok(Finding::Done)
}

/// The package as it is distributed, in a folder of its own.
fn wheel() -> Result<PathBuf, Failure> {
    let folder = target().join("clean-root/wheel");
    if folder.exists() {
        let removed = fs::remove_dir_all(&folder);
        removed.map_err(|error| Failure::new(format!("{}: {error}", folder.display())))?;
    }
    let mut pip = python(OLDEST).ok_or_else(|| Failure::new("there is no Python here"))?;
    pip.current_dir(root()).args(["-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir"]);
    run(pip.arg(&folder).arg("crates/python"), "the wheel must build")?;
    let found = fs::read_dir(&folder).ok().and_then(|mut files| files.next()?.ok());
    found.map(|file| file.path()).ok_or_else(|| Failure::new("pip has made no wheel"))
}

/// Creates the root if it does not exist.
fn made(suite: &str, folder: &Path) -> Result<(), Failure> {
    if folder.join("etc/debian_version").is_file() {
        return Ok(());
    }
    let mut bootstrap = Command::new("debootstrap");
    bootstrap.args(["--variant=minbase", PACKAGES, suite]).arg(folder);
    run(&mut bootstrap, "it must be run as root, and reach Debian's packages")
}

fn furnish(folder: &Path, wheel: &Path) -> io::Result<()> {
    for file in NETWORK {
        let here = Path::new("/").join(file);
        if here.is_file() {
            fs::copy(here, folder.join(file))?;
        }
    }
    let desk = folder.join(DESK);
    if desk.exists() {
        fs::remove_dir_all(&desk)?;
    }
    fs::create_dir_all(&desk)?;
    copy(&target().join("release/wholestring"), &desk.join("wholestring"))?;
    copy(&root().join("cases"), &desk.join("cases"))?;
    copy(wheel, &desk.join(wheel.file_name().unwrap_or_default()))
}

/// Runs the README's first example with the program, and its quick start in Python.
fn tried(folder: &Path) -> Result<(), Failure> {
    let script = format!(
        "set -e; cd /{DESK}; \
         if command -v rustc cargo; then echo 'there is Rust here'; exit 1; fi; \
         ./wholestring run cases/np13-x1042.toml; \
         python3 -m venv fresh; fresh/bin/pip install --quiet ./*.whl; \
         fresh/bin/python -c \"$QUICK_START\""
    );
    let mut inside = Command::new("chroot");
    inside.arg(folder).args(["/bin/sh", "-c", &script]).env("QUICK_START", readme_quick_start()?);
    run(&mut inside, "the distributed program and wheel must run without Rust")
}
