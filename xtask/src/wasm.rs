//! The engine in WebAssembly: checks that it compiles for the browser, and the page that runs it
//! there.

use std::{
    env,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, cargo, program, run},
    finding::Finding,
    folders::{root, target},
    web::{Web, installed_browser, unable},
};

const TARGET: &str = "wasm32-unknown-unknown";

/// The page's sources.
const WEB: Web = Web("web/app");

/// Reason why nothing can be compiled for the browser here, if so.
fn lacking() -> Option<String> {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let sysroot = Command::new(rustc).args(["--print", "sysroot"]).output();
    let installed = sysroot.is_ok_and(|output| {
        let root = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        Path::new(&root).join("lib/rustlib").join(TARGET).is_dir()
    });
    (!installed).then(|| format!("the target is not installed (`rustup target add {TARGET}`)"))
}

/// Core alone compiles, with and without SIMD of WebAssembly.
pub(crate) fn core() -> Result<Finding, Failure> {
    if let Some(reason) = lacking() {
        return Ok(Finding::Skipped(reason));
    }
    run(
        cargo().args(["check", "--package", "wholestring", "--target", TARGET]),
        "core must compile for the browser: no files, no threads, no clock",
    )?;
    Ok(Finding::Done)
}

/// The engine, optimised for size and with SIMD of WebAssembly. It has its own profile, because
/// browsers download it.
fn engine() -> Result<PathBuf, Failure> {
    let mut build = cargo();
    build.args(["build", "--quiet", "--target", TARGET, "--profile", "browser"]);
    build.args(["--package", "wholestring-browser"]);
    build.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-C target-feature=+simd128");
    run(&mut build, "the engine must compile for the browser")?;
    Ok(target().join(TARGET).join("browser/wholestring_browser.wasm"))
}

/// Makes the page that needs no server of its own, in `target/playground`.
pub(crate) fn playground() -> Result<Finding, Failure> {
    if let Some(reason) = lacking() {
        return Err(Failure::new(reason));
    }
    WEB.install().map_err(Failure::new)?;
    let engine = engine()?;
    run(
        Command::new("node").current_dir(WEB.folder()).arg("playground.mjs").arg(engine),
        "the page must be bundled",
    )?;
    Ok(Finding::Done)
}

/// The page without a server works, and its results equal those of the program.
pub(crate) fn browser() -> Result<Finding, Failure> {
    if let Some(reason) = lacking() {
        return Ok(Finding::Skipped(reason));
    }
    if let Err(reason) = WEB.install() {
        return unable(reason);
    }
    let browser = match installed_browser() {
        Ok(browser) => browser,
        Err(reason) => return unable(reason),
    };
    playground()?;
    let native = program("--bin", "wholestring")?;
    let mut test = Command::new("node");
    test.current_dir(root().join("web/app/test")).arg("alone.mjs");
    test.env("WHOLESTRING", native.get_program()).env("CHROMIUM", &browser);
    run(&mut test, "the page must work in a browser alone")?;
    Ok(Finding::Done)
}
