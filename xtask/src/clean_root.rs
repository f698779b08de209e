//! The program and the Python package in an empty root of Debian's packages, as one installs them
//! who has no Rust: what the system must have, and no more.

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

/// Releases of Debian that are tried where none is named.
const SUITES: [&str; 2] = ["stable", "oldstable"];

/// What the wheel asks of the system.
const PACKAGES: &str = "--include=python3,python3-venv,ca-certificates";

/// Files of this machine without which no package is fetched from inside: names of servers, and
/// whose certificates are trusted.
const NETWORK: [&str; 2] = ["etc/resolv.conf", "etc/ssl/certs/ca-certificates.crt"];

/// Where in the root the program stands.
const DESK: &str = "desk";

/// Tries each of the releases of Debian. Takes minutes, debootstrap, and rights over the machine.
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

/// The package as it is given to others, in a folder of its own.
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

/// Makes the root where it is not there from another time.
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

/// The README's first example by the program, and its quick start in Python.
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
    run(&mut inside, "what is given to others must run without Rust")
}
