//! Serves the app until it is interrupted.

use std::process;

use wholestring_app::{Options, Server, ServerError};

use super::AppArgs;
use crate::{
    failure::{Failure, failed},
    terminal::{print_stderr, print_stdout},
};

pub(crate) fn app(args: &AppArgs) -> Result<(), Failure> {
    let options = Options { folder: args.folder.clone(), port: args.port };
    let server = Server::bind(&options).map_err(refused)?;
    let url = server.url();
    let stop = server.stop();
    // The first Ctrl-C closes open connections gracefully, the second exits at once.
    let _ = ctrlc::set_handler(move || {
        if stop.stop() {
            process::exit(130);
        }
    });
    print_stdout(&format!("{url}\nopen this address in a browser; Ctrl-C ends the program\n"))?;
    if !args.no_browser
        && let Err(error) = open::that_detached(&url)
    {
        print_stderr(&format!("no browser could be opened: {error}\n"));
    }
    server.run().map_err(refused)
}

fn refused(error: ServerError) -> Failure {
    match error {
        ServerError::Folder(_) | ServerError::Port { .. } => {
            Failure::BadInput(format!("error: {error}"))
        }
        ServerError::System(_) => failed(&error),
    }
}
