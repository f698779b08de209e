//! Recorded set points, with their times.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::set_points::SetPoints;

/// Set points at a time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordedEvent {
    /// Simulated time, s, at a sample.
    pub at_s: f64,
    /// The new set points.
    pub set: SetPoints,
    /// The set points before; a ramp in progress is cut off there.
    pub before: SetPoints,
}

/// All recorded set points, in the order of time.
#[derive(Debug, Clone, Default)]
pub(super) struct Recording(Vec<RecordedEvent>);

/// Maximum number of events, more than an hour of continuous changes makes.
pub(super) const MOST_EVENTS: usize = 20_000;

impl Recording {
    pub(super) fn of(events: Vec<RecordedEvent>) -> Self {
        Self(events)
    }

    pub(super) fn events(&self) -> &[RecordedEvent] {
        &self.0
    }

    /// Adds an event. Of several at the same time, the later values apply.
    pub(super) fn add(&mut self, event: RecordedEvent) {
        match self.0.last_mut() {
            Some(last) if last.at_s == event.at_s => last.set.merge(event.set),
            _ => self.0.push(event),
        }
    }

    /// Removes the events from a time on.
    pub(super) fn split_from(&mut self, time_s: f64) -> Vec<RecordedEvent> {
        let place = self.0.partition_point(|event| event.at_s < time_s);
        self.0.split_off(place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn event(at_s: f64, speed: f64) -> RecordedEvent {
        let set = SetPoints { rotary_speed_rad_per_s: Some(speed), ..SetPoints::default() };
        RecordedEvent { at_s, set, before: SetPoints::default() }
    }

    #[test]
    fn what_is_set_at_a_checkpoint_comes_after_it() {
        let mut all = Recording::default();
        [event(1.0, 5.0), event(2.0, 6.0), event(2.0, 7.0), event(3.0, 8.0)]
            .into_iter()
            .for_each(|event| all.add(event));
        assert_eq!(all.events().len(), 3);
        let later = all.split_from(2.0);
        assert_eq!(later[0].set.rotary_speed_rad_per_s, Some(7.0));
        assert_eq!((all.events().len(), later.len()), (1, 2));
    }
}
