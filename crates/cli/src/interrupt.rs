//! Ctrl-C: the first requests a stop, the second exits at once.

use std::process;

use wholestring_runner::CancellationToken;

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
