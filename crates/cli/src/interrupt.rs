//! Ctrl-C: the first asks to stop, the second stops at once.

use std::process;

use wholestring_runner::CancellationToken;

/// Listens for Ctrl-C from now on. Where the system allows no listening, Ctrl-C ends the program
/// as it does any other.
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
