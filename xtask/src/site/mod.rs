//! The book as a site, built by mdBook with equations that browsers render.

mod equations;
mod fragments;
mod inline;
mod links;
mod playground;
mod preprocessor;
mod tree;

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

pub(crate) use fragments::{check as check_equations, write as write_equations};
pub(crate) use preprocessor::equations;

/// The release that builds the book. Serving and watching are left out because they take long to
/// compile.
const MDBOOK: &str = "mdbook@0.5.4";

/// The book builds: each page in its summary exists, each equation can be converted, and each link
/// has a target. It includes the app that runs in a browser alone, if that has been built.
pub(crate) fn build() -> Result<Finding, Failure> {
    let Some(mdbook) = found().or_else(installed) else {
        return unable(format!("there is no mdbook, and `cargo install {MDBOOK}` fails here"));
    };
    let mut build = Command::new(mdbook);
    build.current_dir(root()).args(["build", "docs"]);
    playground::announce(&mut build);
    run(&mut build, "the book must build")?;
    let site = target().join("book");
    if playground::put_in(site.clone())? {
        println!("{}, with the app that runs in a browser alone", site.display());
    }
    links::check(&site)?;
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

/// Installs it once in the folder of builds.
fn installed() -> Option<PathBuf> {
    let mut install = cargo();
    install.args(["install", "--quiet", "--locked", MDBOOK, "--debug"]);
    install.args(["--no-default-features", "--features", "search", "--root"]);
    // Its dependencies are not ours: they would be compiled repeatedly in the same folder.
    install.arg(folder()).arg("--target-dir").arg(folder().join("build"));
    install.env("CARGO_PROFILE_DEV_DEBUG", "0");
    succeeds(&mut install).then(found).flatten()
}
