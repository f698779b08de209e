//! Pace of the simulated time.

use std::time::Duration;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_runner::Instant;

/// Maximum wall-clock time of a slice, so that the picture moves at least thirty times a second.
const SLICE: Duration = Duration::from_millis(25);

/// Maximum delay that is caught up; a string further behind continues from its present time.
const BEHIND: Duration = Duration::from_millis(250);

/// Time over which the achieved pace is measured.
const MEASURED: Duration = Duration::from_secs(1);

/// Simulated seconds per wall-clock second.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(untagged)]
pub enum Pace {
    /// This ratio.
    Times(f64),
    /// As fast as possible.
    Fastest(Fastest),
}

/// As fast as possible.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum Fastest {
    /// As fast as possible.
    Max,
}

impl Pace {
    /// Whether the pace is valid.
    pub fn is_sound(self) -> bool {
        match self {
            Self::Times(times) => (0.01..=1000.0).contains(&times),
            Self::Fastest(_) => true,
        }
    }
}

/// Keeps a pace: determines the next advance and the next wait.
#[derive(Debug)]
pub(super) struct Pacer {
    pace: Pace,
    /// A moment, and its simulated time.
    origin: (Instant, f64),
    /// Simulated seconds per second of computation, from the last slices.
    able: f64,
    /// Start of the present measurement.
    measured_from: (Instant, f64),
    reached: f64,
}

/// The next action.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Next {
    /// Advances by this many samples.
    Go(u64),
    /// Waits this long.
    Wait(Duration),
}

impl Pacer {
    pub(super) fn new(pace: Pace, now: Instant, time_s: f64) -> Self {
        let origin = (now, time_s);
        Self { pace, origin, able: 1.0, measured_from: origin, reached: 0.0 }
    }

    /// Restarts from this time.
    pub(super) fn restart(&mut self, pace: Pace, now: Instant, time_s: f64) {
        (self.pace, self.origin) = (pace, (now, time_s));
        (self.measured_from, self.reached) = ((now, time_s), 0.0);
    }

    pub(super) fn pace(&self) -> Pace {
        self.pace
    }

    /// Simulated seconds per wall-clock second, achieved recently.
    pub(super) fn reached(&self) -> f64 {
        self.reached
    }

    /// Simulated seconds per second of computation.
    pub(super) fn able(&self) -> f64 {
        self.able
    }

    /// The action that is due.
    pub(super) fn next(&mut self, now: Instant, time_s: f64, sample_s: f64) -> Next {
        let most = ((self.able * SLICE.as_secs_f64() / sample_s) as u64).max(1);
        let Pace::Times(times) = self.pace else { return Next::Go(most) };
        let target_s = self.origin.1 + times * (now - self.origin.0).as_secs_f64();
        let behind_s = target_s - time_s;
        if behind_s > times * BEHIND.as_secs_f64() + 2.0 * sample_s {
            self.origin = (now, time_s);
        }
        let due = (behind_s / sample_s).max(0.0) as u64;
        // Samples are computed in slices, not one by one, when many are due.
        let least = ((times * SLICE.as_secs_f64() / sample_s) as u64).clamp(1, most);
        if due >= least {
            return Next::Go(due.min(most));
        }
        let missing_s = (least as f64 * sample_s - behind_s) / times;
        Next::Wait(Duration::from_secs_f64(missing_s.clamp(1e-4, 0.25)))
    }

    /// Records the duration of a slice.
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

    /// A string that computes `able` simulated seconds per second, on a simulated clock.
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

    /// The pace is kept if the machine is able to, within a slice per second; otherwise it is the
    /// machine's maximum.
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
