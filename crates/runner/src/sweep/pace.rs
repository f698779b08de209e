//! How often a table is written while its cases are solved.

use std::time::Duration;

use crate::clock::Instant;

/// Least time between two writings.
const INTERVAL: Duration = Duration::from_secs(5);

/// A writing takes at most one part in so many of the time: a table of 100 000 rows takes seconds.
const SHARE: u32 = 20;

/// When the table is written next.
pub(super) struct Pace(Instant);

impl Default for Pace {
    fn default() -> Self {
        Self(Instant::now() + INTERVAL)
    }
}

impl Pace {
    /// Writes, if it is time to.
    pub(super) fn when_due(&mut self, write: impl FnOnce()) {
        let begin = Instant::now();
        if begin < self.0 {
            return;
        }
        write();
        self.0 = Instant::now() + INTERVAL.max(SHARE * begin.elapsed());
    }
}
