//! The time that this thread had of the processor.

use std::time::Duration;

use serde::Serialize;

/// What a [`Spread`] of times is of: the processor or the clock.
pub const TIME: &str = kind::NAME;

#[cfg(any(target_os = "linux", target_os = "macos", target_os = "freebsd"))]
mod kind {
    use std::time::Duration;

    use rustix::time::{ClockId, clock_gettime};

    pub(super) const NAME: &str = "CPU time of one thread";

    /// Whatever else the machine does is not in it.
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

    /// The thread's own time comes in ticks of 16 ms on Windows: too coarse.
    pub(super) fn now() -> Duration {
        BEGINNING.get_or_init(Instant::now).elapsed()
    }
}

/// Time since it was begun.
pub(super) struct Clock(Duration);

impl Clock {
    pub(super) fn begin() -> Self {
        Self(kind::now())
    }

    pub(super) fn elapsed_s(&self) -> f64 {
        (kind::now() - self.0).as_secs_f64()
    }
}

/// What repeated measurements gave.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Spread {
    /// The middle one, or half-way between the two in the middle.
    pub median: f64,
    /// The least.
    pub least: f64,
    /// The most.
    pub most: f64,
}

impl Spread {
    /// Of at least one number.
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
        let of = |found: &[f64]| {
            let Spread { median, least, most } = Spread::of(found.to_vec());
            [median, least, most]
        };
        assert_eq!(of(&[3.0]), [3.0, 3.0, 3.0]);
        assert_eq!(of(&[5.0, 1.0, 2.0]), [2.0, 1.0, 5.0]);
        assert_eq!(of(&[5.0, 1.0, 2.0, 4.0]), [3.0, 1.0, 5.0]);
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
