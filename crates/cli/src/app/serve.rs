//! Serves the app until it is interrupted.

use std::process;

use wholestring_app::{Address, Links, Options, Server, ServerError};

use super::AppArgs;
use crate::{
    failure::{Failure, failed},
    terminal::{print_stderr, print_stdout},
};

pub(crate) fn app(args: &AppArgs) -> Result<(), Failure> {
    let address = if args.plain_address { Address::Plain } else { Address::Automatic };
    let options = Options { folder: args.folder.clone(), port: args.port, address };
    let server = Server::bind(&options).map_err(refused)?;
    let (links, stop) = (server.links(), server.stop());
    // The first Ctrl-C closes open connections gracefully, the second exits at once.
    let open = links.clone();
    let _ = ctrlc::set_handler(move || {
        if stop.stop() {
            open.close();
            process::exit(130);
        }
    });
    if server.is_plain() {
        print_stderr(PLAIN);
    }
    let link = link(&links).map_err(|error| failed(&error))?;
    print_stdout(&format!("{link}\n{USE}"))?;
    if !args.no_browser
        && let Err(error) = links.file().and_then(open::that_detached)
    {
        print_stderr(&format!("no browser could be opened: {error}\n"));
    }
    server.run().map_err(refused)
}

const USE: &str = "open this link in a browser: it lets in one browser, once, and the next link is \
    printed after its use; Ctrl-C ends the program\n";

const PLAIN: &str = "warning: at 127.0.0.1 the browser sends the cookie of the app to servers on \
    other ports of this machine too: visit none that is another user's\n";

/// A link that lets one browser in. After its use the next one is printed, for another browser.
fn link(links: &Links) -> std::io::Result<String> {
    let next = links.clone();
    links.address(move || match link(&next) {
        // Where nobody reads the output, nobody waits for a link.
        Ok(link) => drop(print_stdout(&format!("{link}\nthe link for another browser\n"))),
        Err(error) => print_stderr(&format!("no further link could be made: {error}\n")),
    })
}

fn refused(error: ServerError) -> Failure {
    match error {
        ServerError::Folder(_) | ServerError::Port { .. } => {
            Failure::BadInput(format!("error: {error}"))
        }
        ServerError::System(_) => failed(&error),
    }
}
