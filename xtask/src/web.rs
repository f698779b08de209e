//! Folders of pages' sources, which npm installs, and the browser that tests the pages.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{
    command::{Failure, run, succeeds},
    finding::Finding,
    folders::root,
};

/// Names under which a browser of the Chromium family may be installed.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// A folder with a `package.json`, from the root of the repository.
pub(crate) struct Web(pub(crate) &'static str);

impl Web {
    /// The folder.
    pub(crate) fn folder(&self) -> PathBuf {
        root().join(self.0)
    }

    /// npm in this folder.
    pub(crate) fn npm(&self) -> Command {
        let mut npm = Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" });
        npm.current_dir(self.folder());
        npm
    }

    /// Whether the committed bundle equals that of the sources.
    pub(crate) fn bundle(&self) -> Result<Finding, Failure> {
        if let Err(reason) = self.install() {
            return unable(reason);
        }
        run(
            self.npm().args(["run", "--silent", "check"]),
            "the program embeds the bundle, so that it needs no Node",
        )?;
        Ok(Finding::Done)
    }

    /// Installs the sources' dependencies once, as in the lock file.
    pub(crate) fn install(&self) -> Result<(), String> {
        if !succeeds(self.npm().arg("--version")) {
            return Err("there is no Node with npm here".into());
        }
        let modified = |path: &Path| fs::metadata(path).and_then(|data| data.modified()).ok();
        let locked = modified(&self.folder().join("package-lock.json"));
        let installed = modified(&self.folder().join("node_modules/.package-lock.json"));
        if installed.is_some() && installed >= locked {
            return Ok(());
        }
        if succeeds(self.npm().args(["ci", "--no-audit", "--no-fund"])) {
            Ok(())
        } else {
            Err(format!("`npm ci` in {} does not work here", self.0))
        }
    }
}

/// Skips a step that cannot be tested here, with the reason; fails where every change is tested.
pub(crate) fn unable(reason: String) -> Result<Finding, Failure> {
    if env::var_os("CI").is_some() {
        return Err(Failure::new(reason));
    }
    Ok(Finding::Skipped(reason))
}

/// Returns a browser of the Chromium family, installed on Debian if there is none and it is
/// possible; otherwise the reason.
pub(crate) fn installed_browser() -> Result<PathBuf, String> {
    let browser = find().or_else(fetch);
    browser.ok_or_else(|| "there is no Chromium, and it cannot be installed here".into())
}

/// A browser in one of the usual folders of programs.
fn find() -> Option<PathBuf> {
    let folders = env::var_os("PATH")?;
    env::split_paths(&folders)
        .flat_map(|folder| BROWSERS.map(|name| folder.join(name)))
        .find(|path| path.is_file())
}

/// Installs Debian's Chromium, if this is possible without a prompt.
fn fetch() -> Option<PathBuf> {
    let apt = |words: &[&str]| {
        let mut command = Command::new("apt-get");
        command.env("DEBIAN_FRONTEND", "noninteractive").args(words);
        succeeds(&mut command)
    };
    let install = ["install", "--yes", "--no-install-recommends", "chromium"];
    let done = apt(&install) || (apt(&["update"]) && apt(&install));
    done.then(find).flatten()
}
