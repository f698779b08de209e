//! How fast simulated time goes.

use std::time::Duration;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_runner::Instant;

/// Wall-clock time of a slice at most: what a viewer sees moves at least thirty times a second.
const SLICE: Duration = Duration::from_millis(25);

/// Time that may be made up for: a string that is further behind goes on from where it is.
const BEHIND: Duration = Duration::from_millis(250);

/// Over how long the pace that is reached is measured.
const MEASURED: Duration = Duration::from_secs(1);

/// Simulated seconds in one on the clock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
pub enum Pace {
    /// So many.
    Times(f64),
    /// As fast as it goes.
    Fastest(Fastest),
}

/// As fast as it goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Fastest {
    /// As fast as it goes.
    Max,
}

impl Pace {
    /// Whether it is one that there is.
    pub fn is_sound(self) -> bool {
        match self {
            Self::Times(times) => (0.01..=1000.0).contains(&times),
            Self::Fastest(_) => true,
        }
    }
}

/// Keeps a pace: says how far to go next and how long to wait.
#[derive(Debug)]
pub(super) struct Pacer {
    pace: Pace,
    /// A moment, and the simulated time that belongs to it.
    origin: (Instant, f64),
    /// Simulated seconds that a second on the clock computes, as the last slices did.
    able: f64,
    /// Where a measurement began.
    measured_from: (Instant, f64),
    reached: f64,
}

/// What to do next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Next {
    /// Go so many samples.
    Go(u64),
    /// Nothing is due for so long.
    Wait(Duration),
}

impl Pacer {
    pub(super) fn new(pace: Pace, now: Instant, time_s: f64) -> Self {
        let origin = (now, time_s);
        Self { pace, origin, able: 1.0, measured_from: origin, reached: 0.0 }
    }

    /// Goes on from here.
    pub(super) fn restart(&mut self, pace: Pace, now: Instant, time_s: f64) {
        (self.pace, self.origin) = (pace, (now, time_s));
        (self.measured_from, self.reached) = ((now, time_s), 0.0);
    }

    pub(super) fn pace(&self) -> Pace {
        self.pace
    }

    /// Simulated seconds in one on the clock, as it was of late.
    pub(super) fn reached(&self) -> f64 {
        self.reached
    }

    /// Simulated seconds that a second on the clock computes.
    pub(super) fn able(&self) -> f64 {
        self.able
    }

    /// What is due.
    pub(super) fn next(&mut self, now: Instant, time_s: f64, sample_s: f64) -> Next {
        let most = ((self.able * SLICE.as_secs_f64() / sample_s) as u64).max(1);
        let Pace::Times(times) = self.pace else { return Next::Go(most) };
        let target_s = self.origin.1 + times * (now - self.origin.0).as_secs_f64();
        let behind_s = target_s - time_s;
        if behind_s > times * BEHIND.as_secs_f64() + 2.0 * sample_s {
            self.origin = (now, time_s);
        }
        let due = (behind_s / sample_s).max(0.0) as u64;
        // Not sample by sample where many are wanted: a slice at a time.
        let least = ((times * SLICE.as_secs_f64() / sample_s) as u64).clamp(1, most);
        if due >= least {
            return Next::Go(due.min(most));
        }
        let missing_s = (least as f64 * sample_s - behind_s) / times;
        Next::Wait(Duration::from_secs_f64(missing_s.clamp(1e-4, 0.25)))
    }

    /// Learns what a slice took.
    pub(super) fn went(&mut self, began: Instant, now: Instant, simulated_s: f64, time_s: f64) {
        let took_s = (now - began).as_secs_f64().max(1e-6);
        self.able += 0.2 * (simulated_s / took_s - self.able);
        let since = now - self.measured_from.0;
        if since >= MEASURED {
            self.reached = (time_s - self.measured_from.1) / since.as_secs_f64();
            self.measured_from = (now, time_s);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLE_S: f64 = 0.01;

    /// A string that computes `able` simulated seconds in one, on a clock that only this moves.
    fn reaches(pace: Pace, able: f64) -> f64 {
        let begin = Instant::now();
        let (mut clock_s, mut time_s) = (0.0, 0.0);
        let at = |s: f64| begin + Duration::from_secs_f64(s);
        let mut pacer = Pacer::new(pace, begin, 0.0);
        while clock_s < 10.0 {
            match pacer.next(at(clock_s), time_s, SAMPLE_S) {
                Next::Wait(time) => clock_s += time.as_secs_f64(),
                Next::Go(samples) => {
                    let (before, simulated_s) = (clock_s, samples as f64 * SAMPLE_S);
                    clock_s += simulated_s / able;
                    time_s += simulated_s;
                    pacer.went(at(before), at(clock_s), simulated_s, time_s);
                }
            }
        }
        pacer.reached()
    }

    /// Kept where the machine is able to, to a slice in a second; else as fast as it is able to.
    #[test]
    fn a_pace_is_kept_as_far_as_it_can_be() {
        for (pace, able, expected) in [
            (Pace::Times(1.0), 36.0, 1.0),
            (Pace::Times(10.0), 36.0, 10.0),
            (Pace::Times(0.1), 36.0, 0.1),
            (Pace::Times(10.0), 4.0, 4.0),
            (Pace::Fastest(Fastest::Max), 36.0, 36.0),
        ] {
            let reached = reaches(pace, able);
            assert!((reached / expected - 1.0).abs() < 0.03, "{pace:?}: {reached}");
        }
    }

    #[test]
    fn a_pace_is_a_number_or_a_word() {
        let times: Pace = serde_json::from_str("2.5").expect("a pace");
        let fastest: Pace = serde_json::from_str("\"max\"").expect("a pace");
        assert_eq!((times, fastest), (Pace::Times(2.5), Pace::Fastest(Fastest::Max)));
        assert!(!Pace::Times(0.0).is_sound() && !Pace::Times(f64::NAN).is_sound());
    }
}
