//! The page of the local web app: checks that its committed bundle equals that of its sources, and
//! that its screens work in a browser.

use std::process::Command;

use crate::{
    command::{Failure, program, run},
    finding::Finding,
    web::{Web, installed_browser, unable},
};

/// Sources of the page.
const WEB: Web = Web("web/app");

/// A test for each screen.
const SCREENS: [&str; 4] = ["case.mjs", "answers.mjs", "seat.mjs", "work.mjs"];

/// The bundle in `crates/app/assets` equals that of `web/app`, whose types are correct.
pub(crate) fn bundle() -> Result<Finding, Failure> {
    WEB.bundle()
}

/// Each screen works by mouse and keyboard.
pub(crate) fn browser() -> Result<Finding, Failure> {
    if let Err(reason) = WEB.install() {
        return unable(reason);
    }
    let browser = match installed_browser() {
        Ok(browser) => browser,
        Err(reason) => return unable(reason),
    };
    let served = program("--bin", "wholestring")?;
    for screen in SCREENS {
        let mut test = Command::new("node");
        test.current_dir(WEB.folder().join("test")).arg(screen);
        test.env("WHOLESTRING", served.get_program()).env("CHROMIUM", &browser);
        run(&mut test, "each screen must work in a browser")?;
    }
    Ok(Finding::Done)
}
