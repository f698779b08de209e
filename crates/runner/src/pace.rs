//! How far a simulation goes between two looks at a cancellation.

use std::time::Duration;

use crate::clock::Instant;

/// Wall-clock time between two looks. Whoever interrupts waits for this at most, and for what is
/// written then.
const LOOK: Duration = Duration::from_millis(40);

/// How many samples a simulation takes before it looks again: so many as took [`LOOK`] the last
/// time, however fast or slow the run is. The answer does not depend on it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace {
    samples: u64,
    most: u64,
}

impl Pace {
    /// Of a run that is sampled every `sample_s` and looks at least every `most_s` simulated.
    pub(crate) fn new(most_s: f64, sample_s: f64) -> Self {
        // Nobody knows yet how long a sample takes.
        Self { samples: 1, most: ((most_s / sample_s).round() as u64).max(1) }
    }

    /// Does the work of so many samples, of which `left` are left at most.
    pub(crate) fn work<T>(&mut self, left: u64, of: impl FnOnce(u64) -> T) -> T {
        let samples = self.samples.min(left);
        let begun = Instant::now();
        let done = of(samples);
        self.took(samples, begun.elapsed());
        done
    }

    fn took(&mut self, samples: u64, took: Duration) {
        let fit = samples as f64 * LOOK.as_secs_f64() / took.as_secs_f64().max(1e-9);
        // At most four times as many: one sample may be quicker than the rest.
        self.samples = (fit as u64).clamp(1, self.most).min(samples.saturating_mul(4));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of a pace after some looks, each sample of this length.
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
        // A sample longer than that is looked after each time.
        assert_eq!(settled(0.2, 0.01, Duration::from_millis(90)), 1);
        // A fast one as often as it simulates so much.
        assert_eq!(settled(0.2, 0.01, Duration::from_micros(1)), 20);
        // A pause of the machine is made good.
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
