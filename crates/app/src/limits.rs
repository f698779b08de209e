//! Limits of the server.

use std::time::Duration;

/// Limits of the server. Requests beyond them are refused with a message.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// Size of the body of a request, bytes.
    pub(crate) body_bytes: usize,
    /// The same for all but uploads of files: a text as JSON.
    pub(crate) json_bytes: usize,
    /// Size beyond which a body is large, bytes; a body of undeclared length is large, too.
    pub(crate) small_body_bytes: usize,
    /// Number of concurrent requests with large bodies; further ones wait.
    pub(crate) large_bodies: usize,
    /// Size of the head of a request, bytes.
    pub(crate) head_bytes: usize,
    /// Number of header fields of a request.
    pub(crate) header_fields: usize,
    /// Number of connections; further ones replace the oldest without an admitted request, or
    /// wait.
    pub(crate) connections: usize,
    /// Time in which a new connection without a request is not replaced.
    pub(crate) silent_time: Duration,
    /// Time for the head of a request to arrive, also on an idle connection.
    pub(crate) head_time: Duration,
    /// Time for the body of a request to arrive and the response to begin.
    pub(crate) request_time: Duration,
    /// Number of live strings.
    pub(crate) live_strings: usize,
    /// Memory of the checkpoints of a live string, bytes.
    pub(crate) live_checkpoint_bytes: usize,
    /// Number of samples that a live string keeps for viewers that join later.
    pub(crate) live_samples: usize,
    /// Time without a viewer after which a live string ends.
    pub(crate) live_idle: Duration,
    /// Number of pages that view live strings.
    pub(crate) live_viewers: usize,
    /// Time for open responses to finish when the server stops.
    pub(crate) closing_time: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            body_bytes: 64 << 20,
            json_bytes: 16 << 20,
            small_body_bytes: 1 << 20,
            large_bodies: 2,
            head_bytes: 32 << 10,
            header_fields: 64,
            // macOS allows a program 256 open files by default.
            connections: 128,
            // The system keeps some hundred connections until they are accepted, and makes further
            // clients wait for a second: the time is short, so that a burst is accepted at once.
            silent_time: Duration::from_millis(2),
            head_time: Duration::from_secs(10),
            request_time: Duration::from_secs(120),
            live_strings: 4,
            live_checkpoint_bytes: 48 << 20,
            live_samples: 1 << 16,
            live_idle: Duration::from_secs(600),
            live_viewers: 16,
            closing_time: Duration::from_secs(2),
        }
    }
}
