//! `wholestring app`: the local web app, if the program was built with it.

#[cfg(feature = "app")]
mod serve;

use std::path::PathBuf;

use clap::Args;

#[cfg(feature = "app")]
pub(crate) use serve::app;

#[derive(Debug, Args)]
pub(crate) struct AppArgs {
    /// Folder of the cases; the app reads and writes nothing outside it
    #[arg(value_name = "FOLDER", default_value = ".")]
    pub(crate) folder: PathBuf,
    /// Port of the loopback addresses to serve on [default: a free port]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub(crate) port: u16,
    /// Print the link and open no browser
    #[arg(long)]
    pub(crate) no_browser: bool,
    /// Serve as 127.0.0.1, for a browser that does not find names under localhost (Safari before
    /// macOS 26); other servers of this machine then receive the app's cookie
    #[arg(long)]
    pub(crate) plain_address: bool,
}

/// Explains how to build the program with the app, which it was built without.
#[cfg(not(feature = "app"))]
pub(crate) fn app(args: &AppArgs) -> Result<(), crate::failure::Failure> {
    let AppArgs { folder, port: _, no_browser: _, plain_address: _ } = args;
    Err(crate::failure::Failure::BadInput(format!(
        "error: this program was built without the app; binaries of a release have it\n\
         `cargo run --release --features app -- app {}` builds the program with it and starts it",
        folder.display()
    )))
}
