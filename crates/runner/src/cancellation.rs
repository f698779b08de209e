//! A request to stop, which work looks at as it goes on.

use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

/// A flag that asks work to stop. Its clones are the same flag, so that a signal handler or another
/// thread can hold one.
///
/// Work that is asked to stop keeps what it has computed and writes a checkpoint from which it can
/// be resumed.
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
    /// A token by which nobody has asked to stop yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Asks to stop, and says whether somebody had asked before.
    pub fn cancel(&self) -> bool {
        self.0.swap(true, Ordering::Relaxed)
    }

    /// From now on nobody has asked.
    pub(crate) fn reset(&self) {
        self.0.store(false, Ordering::Relaxed);
    }

    /// Whether somebody asked to stop.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
