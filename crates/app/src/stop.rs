//! A request to stop the server.

use std::sync::Arc;

use tokio::sync::watch;

/// Stops a server. Its clones stop the same server, from any thread.
#[derive(Debug, Clone)]
pub struct Stop(Arc<watch::Sender<bool>>);

impl Stop {
    pub(crate) fn new() -> Self {
        Self(Arc::new(watch::Sender::new(false)))
    }

    /// Requests the stop, and returns whether it had been requested before.
    pub fn stop(&self) -> bool {
        self.0.send_replace(true)
    }

    /// Waits for a request to stop.
    pub(crate) async fn requested(&self) {
        let mut receiver = self.0.subscribe();
        // The sender is owned here, so that it cannot be closed.
        let _ = receiver.wait_for(|is_requested| *is_requested).await;
    }
}
