//! How much the server takes at once.

use std::time::Duration;

/// How much the server takes at once. What is beyond is refused with a sentence.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// The body of a request, bytes.
    pub(crate) body_bytes: usize,
    /// The same of one that is no upload of files: a text as JSON.
    pub(crate) json_bytes: usize,
    /// A body longer than this is large, bytes, and so is one whose length is not said.
    pub(crate) small_body_bytes: usize,
    /// Requests with large bodies; further ones wait until one is answered.
    pub(crate) large_bodies: usize,
    /// The head of a request, bytes.
    pub(crate) head_bytes: usize,
    /// Header fields of a request.
    pub(crate) header_fields: usize,
    /// Connections; further ones wait until one ends.
    pub(crate) connections: usize,
    /// Time for the head of a request to arrive, on a connection that waits for its next, too.
    pub(crate) head_time: Duration,
    /// Time for the body of a request to arrive and the answer to begin.
    pub(crate) request_time: Duration,
    /// Strings that are live at once.
    pub(crate) live_strings: usize,
    /// Memory of the checkpoints of one of them, bytes.
    pub(crate) live_checkpoint_bytes: usize,
    /// Samples that one of them keeps for who comes late.
    pub(crate) live_samples: usize,
    /// Time after which one ends that nobody looks at.
    pub(crate) live_idle: Duration,
    /// Pages that look at live strings at once.
    pub(crate) live_viewers: usize,
    /// Time for open answers to end once the server is to stop.
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
            connections: 64,
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
