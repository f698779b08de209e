//! Processor time of the current thread.

use std::time::Duration;

use serde::Serialize;

/// Kind of time that a [`Spread`] contains: processor time or wall-clock time.
pub const TIME: &str = kind::NAME;

#[cfg(any(target_os = "linux", target_os = "macos", target_os = "freebsd"))]
mod kind {
    use std::time::Duration;

    use rustix::time::{ClockId, clock_gettime};

    pub(super) const NAME: &str = "CPU time of one thread";

    /// Excludes the load of other programs on the machine.
    pub(super) fn now() -> Duration {
        let time = clock_gettime(ClockId::ThreadCPUTime);
        Duration::new(time.tv_sec.unsigned_abs(), u32::try_from(time.tv_nsec).unwrap_or(0))
    }
}

#[cfg(not(any(target_os = "linux", target_os = "macos", target_os = "freebsd")))]
mod kind {
    use std::{
        sync::OnceLock,
        time::{Duration, Instant},
    };

    pub(super) const NAME: &str = "wall-clock time";

    static BEGINNING: OnceLock<Instant> = OnceLock::new();

    /// On Windows the thread's own time advances in ticks of 16 ms, which is too coarse.
    pub(super) fn now() -> Duration {
        BEGINNING.get_or_init(Instant::now).elapsed()
    }
}

/// Time since it was started.
pub(super) struct Clock(Duration);

impl Clock {
    pub(super) fn begin() -> Self {
        Self(kind::now())
    }

    pub(super) fn elapsed_s(&self) -> f64 {
        (kind::now() - self.0).as_secs_f64()
    }
}

/// Spread of repeated measurements.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Spread {
    /// Median; for an even count the mean of the middle two.
    pub median: f64,
    /// Smallest value.
    pub least: f64,
    /// Largest value.
    pub most: f64,
}

impl Spread {
    /// Computes the spread of at least one number.
    pub(super) fn of(mut found: Vec<f64>) -> Self {
        found.sort_by(f64::total_cmp);
        let middle = found.len() / 2;
        let median = if found.len() % 2 == 1 {
            found[middle]
        } else {
            0.5 * (found[middle - 1] + found[middle])
        };
        Self { median, least: found[0], most: found[found.len() - 1] }
    }

    pub(super) fn times(self, factor: f64) -> Self {
        Self { median: factor * self.median, least: factor * self.least, most: factor * self.most }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle_one_or_between_two() {
        let spread = |found: &[f64]| {
            let Spread { median, least, most } = Spread::of(found.to_vec());
            [median, least, most]
        };
        assert_eq!(spread(&[3.0]), [3.0, 3.0, 3.0]);
        assert_eq!(spread(&[5.0, 1.0, 2.0]), [2.0, 1.0, 5.0]);
        assert_eq!(spread(&[5.0, 1.0, 2.0, 4.0]), [3.0, 1.0, 5.0]);
    }

    #[test]
    fn time_goes_on() {
        let clock = Clock::begin();
        let mut last = 0.0;
        while last < 1e-3 {
            let now = clock.elapsed_s();
            assert!(now >= last);
            last = now;
        }
    }
}
