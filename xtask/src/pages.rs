//! Pages of the report and of the app: checks that their committed bundles equal those of their
//! sources, and that they work in a browser, also with the engine in WebAssembly.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{cargo, has_target, program, root, run, succeeds, target, with},
    outcome::{Failure, Finding},
};

/// Folders of the pages' sources, each with a `package.json`.
const REPORT: &str = "crates/report/web";
const APP: &str = "web/app";

/// A test for each screen of the app, and one of the links that let a browser in.
const SCREENS: [&str; 5] = ["link.mjs", "case.mjs", "answers.mjs", "seat.mjs", "work.mjs"];

/// Names under which a browser of the Chromium family may be installed.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

const WASM: &str = "wasm32-unknown-unknown";

/// The bundle in `crates/report/assets` equals that of `crates/report/web`.
pub(crate) fn report_bundle() -> Result<Finding, Failure> {
    bundle(REPORT)
}

/// The bundle in `crates/app/assets` equals that of `web/app`, whose types are correct.
pub(crate) fn app_bundle() -> Result<Finding, Failure> {
    bundle(APP)
}

fn bundle(folder: &str) -> Result<Finding, Failure> {
    let advice = "the program embeds the bundle, so that it needs no Node";
    with(install(folder), |()| run(npm(folder).args(["run", "--silent", "check"]), advice))
}

/// The pages of every command: each plot is drawn, its switches work, and nothing is fetched.
pub(crate) fn report() -> Result<Finding, Failure> {
    with(browser(REPORT), |browser| {
        let made_up = program("--example", "bit_test_page")?;
        let mut node = Command::new("node");
        node.current_dir(root().join(REPORT)).arg("test/all.mjs");
        node.arg(program("--bin", "wholestring")?.get_program()).arg(made_up.get_program());
        run(node.arg(&browser).arg(target()), "the pages must work in a browser")
    })
}

/// Each screen of the app works by mouse and keyboard.
pub(crate) fn app() -> Result<Finding, Failure> {
    with(browser(APP), |browser| SCREENS.iter().try_for_each(|screen| test_app(screen, &browser)))
}

/// Core alone compiles for the browser.
pub(crate) fn core() -> Result<Finding, Failure> {
    if let Some(reason) = lacking() {
        return Ok(Finding::Skipped(reason));
    }
    let advice = "core must compile for the browser: no files, no threads, no clock";
    run(cargo().args(["check", "--package", "wholestring", "--target", WASM]), advice)
        .map(Finding::from)
}

/// Makes the app that needs no server of its own, in `target/playground`. Its engine is optimised
/// for size because browsers download it, and has SIMD of WebAssembly.
pub(crate) fn playground() -> Result<Finding, Failure> {
    if let Some(reason) = lacking() {
        return Err(Failure::new(reason));
    }
    install(APP).map_err(Failure::new)?;
    let mut build = cargo();
    build.args(["build", "--quiet", "--target", WASM, "--profile", "browser"]);
    build.args(["--package", "wholestring-browser"]);
    build.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-C target-feature=+simd128");
    run(&mut build, "the engine must compile for the browser")?;
    let engine = target().join(WASM).join("browser/wholestring_browser.wasm");
    let mut node = Command::new("node");
    node.current_dir(root().join(APP)).arg("playground.mjs").arg(engine);
    run(&mut node, "the page must be bundled").map(Finding::from)
}

/// The app without a server works, and its results equal those of the program.
pub(crate) fn alone() -> Result<Finding, Failure> {
    if let Some(reason) = lacking() {
        return Ok(Finding::Skipped(reason));
    }
    with(browser(APP), |browser| {
        playground()?;
        test_app("alone.mjs", &browser)
    })
}

fn test_app(test: &str, browser: &Path) -> Result<(), Failure> {
    let program = program("--bin", "wholestring")?;
    let mut node = Command::new("node");
    node.current_dir(root().join(APP).join("test")).arg(test);
    node.env("WHOLESTRING", program.get_program()).env("CHROMIUM", browser);
    run(&mut node, "each screen must work in a browser")
}

/// Reason why nothing can be compiled for the browser here, if so.
fn lacking() -> Option<String> {
    let reason = || format!("the target is not installed (`rustup target add {WASM}`)");
    (!has_target(WASM)).then(reason)
}

fn npm(folder: &str) -> Command {
    let mut npm = Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" });
    npm.current_dir(root().join(folder));
    npm
}

/// Installs the dependencies of sources once, as in the lock file.
fn install(folder: &str) -> Result<(), String> {
    if !succeeds(npm(folder).arg("--version")) {
        return Err("there is no Node with npm here".into());
    }
    let modified = |file: &str| {
        let data = fs::metadata(root().join(folder).join(file));
        data.and_then(|data| data.modified()).ok()
    };
    let installed = modified("node_modules/.package-lock.json");
    let is_new = installed.is_some() && installed >= modified("package-lock.json");
    if is_new || succeeds(npm(folder).args(["ci", "--no-audit", "--no-fund"])) {
        return Ok(());
    }
    Err(format!("`npm ci` in {folder} does not work here"))
}

/// A browser of the Chromium family for the tests of these sources, installed on Debian if there is
/// none and it is possible without a prompt; otherwise the reason.
fn browser(folder: &str) -> Result<PathBuf, String> {
    install(folder)?;
    let find = || {
        env::split_paths(&env::var_os("PATH")?)
            .flat_map(|folder| BROWSERS.map(|name| folder.join(name)))
            .find(|path| path.is_file())
    };
    let apt = |words: &[&str]| {
        succeeds(Command::new("apt-get").env("DEBIAN_FRONTEND", "noninteractive").args(words))
    };
    let install = ["install", "--yes", "--no-install-recommends", "chromium"];
    let fetch = || (apt(&install) || (apt(&["update"]) && apt(&install))).then(find).flatten();
    find().or_else(fetch).ok_or_else(|| "there is no Chromium, and it cannot be installed".into())
}
