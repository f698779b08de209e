//! The `app` command of a program that was built without the app.

use super::AppArgs;
use crate::failure::Failure;

/// Explains how to build the program with the app.
pub(crate) fn app(args: &AppArgs) -> Result<(), Failure> {
    let AppArgs { folder, port: _, no_browser: _ } = args;
    Err(Failure::BadInput(format!(
        "error: this program was built without the app; binaries of a release have it\n\
         `cargo run --release --features app -- app {}` builds the program with it and starts it",
        folder.display()
    )))
}
