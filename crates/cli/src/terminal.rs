//! The terminal: printing, and Ctrl-C.

use std::{
    io::{self, Write},
    process,
};

use wholestring_runner::CancellationToken;

use crate::failure::Failure;

/// Prints to standard error. A closed or full stream is ignored, because nothing could report it.
pub(crate) fn print_stderr(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Prints to standard output. A reader that closes the pipe early (`| head`) is no failure.
pub(crate) fn print_stdout(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::Failed(format!("error: cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// A path quoted as a shell argument.
pub(crate) fn in_shell(path: &str) -> String {
    if path.contains(char::is_whitespace) { format!("\"{path}\"") } else { path.to_owned() }
}

// Ctrl-C: the first requests a stop, the second exits at once.

/// Handles Ctrl-C from now on. If the system does not allow a handler, Ctrl-C ends the program as
/// usual.
pub(crate) fn listen() -> CancellationToken {
    let token = CancellationToken::new();
    let cancelled = token.clone();
    let _ = ctrlc::set_handler(move || {
        if cancelled.cancel() {
            process::exit(130);
        }
    });
    token
}
