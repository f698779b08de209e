//! Interval for writing a table while its cases are solved.

use std::time::Duration;

use crate::clock::Instant;

/// Shortest time between two writes.
const INTERVAL: Duration = Duration::from_secs(5);

/// Writing takes at most one part in this many of the time, because a table of 100 000 rows takes
/// seconds.
const SHARE: u32 = 20;

/// Time of the next write.
pub(super) struct Pace(Instant);

impl Default for Pace {
    fn default() -> Self {
        Self(Instant::now() + INTERVAL)
    }
}

impl Pace {
    /// Writes if it is due.
    pub(super) fn when_due(&mut self, write: impl FnOnce()) {
        let begin = Instant::now();
        if begin < self.0 {
            return;
        }
        write();
        self.0 = Instant::now() + INTERVAL.max(SHARE * begin.elapsed());
    }
}
