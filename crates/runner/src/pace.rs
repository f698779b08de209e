//! Length of simulation between two checks for cancellation.

use std::time::Duration;

use crate::clock::Instant;

/// Wall-clock time between two checks. An interruption takes at most this time and the writing that
/// follows.
const LOOK: Duration = Duration::from_millis(40);

/// Number of samples between two checks: as many as took [`LOOK`] the last time, however fast or
/// slow the run is. The results do not depend on it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace {
    samples: u64,
    most: u64,
}

impl Pace {
    /// Creates the pace of a run that is sampled every `sample_s` and checks at least every
    /// `most_s` of simulated time.
    pub(crate) fn new(most_s: f64, sample_s: f64) -> Self {
        // The time of a sample is not known yet.
        Self { samples: 1, most: ((most_s / sample_s).round() as u64).max(1) }
    }

    /// Calls `once` with a number of samples, at most `left`.
    pub(crate) fn work<T>(&mut self, left: u64, once: impl FnOnce(u64) -> T) -> T {
        let samples = self.samples.min(left);
        let begun = Instant::now();
        let done = once(samples);
        self.took(samples, begun.elapsed());
        done
    }

    fn took(&mut self, samples: u64, took: Duration) {
        let fit = samples as f64 * LOOK.as_secs_f64() / took.as_secs_f64().max(1e-9);
        // At most four times as many, because one sample may be quicker than the others.
        self.samples = (fit as u64).clamp(1, self.most).min(samples.saturating_mul(4));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of a pace after some checks, each sample taking this time.
    fn settled(most_s: f64, sample_s: f64, took: Duration) -> u64 {
        let mut pace = Pace::new(most_s, sample_s);
        for _ in 0..20 {
            pace.took(pace.samples, took * u32::try_from(pace.samples).unwrap());
        }
        pace.samples
    }

    #[test]
    fn a_look_comes_by_the_clock() {
        // A run that is slower than real time: 8 ms a sample, 5 samples in 40 ms.
        assert_eq!(settled(0.2, 0.001, Duration::from_millis(8)), 5);
        // With samples longer than that, there is a check after each.
        assert_eq!(settled(0.2, 0.01, Duration::from_millis(90)), 1);
        // A fast run checks at least once per this simulated time.
        assert_eq!(settled(0.2, 0.01, Duration::from_micros(1)), 20);
        // The pace recovers after a pause of the machine.
        let mut pace = Pace::new(0.2, 0.001);
        pace.took(1, Duration::from_secs(5));
        assert_eq!(pace.samples, 1);
        pace.took(1, Duration::from_millis(1));
        assert_eq!(pace.samples, 4);
    }

    #[test]
    fn no_more_is_done_than_is_left() {
        let mut pace = Pace::new(0.2, 0.001);
        pace.samples = 7;
        assert_eq!(pace.work(3, |samples| samples), 3);
    }
}
