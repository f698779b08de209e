//! A request to stop, which running work checks regularly.

use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

/// A flag that requests work to stop. Its clones share the flag, so that a signal handler or
/// another thread can hold one.
///
/// After a request to stop, the work keeps its results so far and writes a checkpoint from which it
/// can be resumed.
///
/// ```
/// use wholestring_runner::CancellationToken;
///
/// let token = CancellationToken::new();
/// let held_elsewhere = token.clone();
/// assert!(!held_elsewhere.cancel());
/// assert!(token.is_cancelled());
/// ```
#[derive(Debug, Clone, Default)]
pub struct CancellationToken(Arc<AtomicBool>);

impl CancellationToken {
    /// Creates a token that is not cancelled.
    pub fn new() -> Self {
        Self::default()
    }

    /// Requests to stop; returns whether this had been requested before.
    pub fn cancel(&self) -> bool {
        self.0.swap(true, Ordering::Relaxed)
    }

    /// Clears the request.
    pub(crate) fn reset(&self) {
        self.0.store(false, Ordering::Relaxed);
    }

    /// Whether a stop was requested.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
