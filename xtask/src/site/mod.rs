//! The book as a site, built by mdBook with equations that browsers set.

mod equations;
mod preprocessor;

use std::{
    env,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, cargo, run, succeeds},
    finding::Finding,
    folders::{root, target},
    web::unable,
};

pub(crate) use preprocessor::equations;

/// The release that builds the book. Serving and watching are left out: they compile for long.
const MDBOOK: &str = "mdbook@0.5.4";

/// The book builds: each page that its summary names is there, and each equation can be set.
pub(crate) fn build() -> Result<Finding, Failure> {
    let Some(mdbook) = found().or_else(installed) else {
        return unable(format!("there is no mdbook, and `cargo install {MDBOOK}` fails here"));
    };
    run(Command::new(mdbook).current_dir(root()).args(["build", "docs"]), "the book must build")?;
    Ok(Finding::Done)
}

fn folder() -> PathBuf {
    target().join("tools")
}

fn found() -> Option<PathBuf> {
    let own = folder().join("bin").join(format!("mdbook{}", env::consts::EXE_SUFFIX));
    let starts = |program: &Path| succeeds(Command::new(program).arg("--version"));
    [own, PathBuf::from("mdbook")].into_iter().find(|program| starts(program))
}

/// Installs it beside what is built here, once.
fn installed() -> Option<PathBuf> {
    let mut install = cargo();
    install.args(["install", "--quiet", "--locked", MDBOOK, "--debug"]);
    install.args(["--no-default-features", "--features", "search", "--root"]);
    // Its parts are none of ours: they would be compiled again and again in the same place.
    install.arg(folder()).arg("--target-dir").arg(folder().join("build"));
    install.env("CARGO_PROFILE_DEV_DEBUG", "0");
    succeeds(&mut install).then(found).flatten()
}
