//! A request to stop the server.

use std::sync::Arc;

use tokio::sync::watch;

/// Asks a server to stop. Its clones ask the same server, from any thread.
#[derive(Debug, Clone)]
pub struct Stop(Arc<watch::Sender<bool>>);

impl Stop {
    pub(crate) fn new() -> Self {
        Self(Arc::new(watch::Sender::new(false)))
    }

    /// Asks to stop, and says whether somebody had asked before.
    pub fn stop(&self) -> bool {
        self.0.send_replace(true)
    }

    /// Waits until somebody asks.
    pub(crate) async fn requested(&self) {
        let mut asked = self.0.subscribe();
        // The sender is held here: it cannot be gone.
        let _ = asked.wait_for(|asked| *asked).await;
    }
}
