//! Status of a live string.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_judge::{Check, Wording};
use wholestring_units::UnitSet;

use super::{checkpoints::CheckpointEntry, lamp::Lamp, pace::Pace};

/// State of a live string.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum LiveState {
    /// It is paused.
    #[default]
    Paused,
    /// It is running.
    Running,
    /// It cannot continue from here, but can be rewound to a checkpoint.
    Failed,
    /// It has ended.
    Ended,
}

/// Status of a live string, sent at changes and a few times a second.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct Status {
    /// Its state.
    pub state: LiveState,
    /// Reason of the state, or of a refused set point, if there is one.
    pub sentence: Option<String>,
    /// Simulated time, s.
    pub time_s: f64,
    /// The requested pace.
    pub pace: Pace,
    /// Simulated seconds per wall-clock second, over the last second.
    pub reached: f64,
    /// Moments to rewind to.
    pub checkpoints: Vec<CheckpointEntry>,
    /// Number of recorded events.
    pub events: usize,
    /// Number of events still to be replayed.
    pub replaying: usize,
    /// Kinetic friction coefficient of each hole section.
    pub friction: Vec<f64>,
    /// The top drive's controller; null if it follows its set point at any torque.
    pub controller: Option<String>,
    /// Reason why it runs slower than its pace, if it does.
    pub slow: Option<String>,
    /// Depth of the hole, m.
    pub hole_depth_m: f64,
    /// The judge's checks of the present motion that need attention, the most severe first:
    /// limits of pipe and rig, and states of the motion.
    pub alarms: Vec<Check>,
    /// Lamps of stick-slip, whirl and top drive.
    pub lamps: Vec<Lamp>,
    /// Number of pages that view it.
    pub viewers: usize,
}

impl Status {
    /// The status of a paused string.
    pub(super) fn new(pace: Pace, time_s: f64) -> Self {
        Self {
            state: LiveState::Paused,
            sentence: None,
            time_s,
            pace,
            reached: 0.0,
            checkpoints: Vec::new(),
            events: 0,
            replaying: 0,
            friction: Vec::new(),
            controller: None,
            slow: None,
            hole_depth_m: 0.0,
            alarms: Vec::new(),
            lamps: Vec::new(),
            viewers: 0,
        }
    }
    /// The same with its sentences in these units.
    #[must_use]
    pub fn in_units(&self, units: UnitSet) -> Self {
        let sentence = self.sentence.as_deref();
        Self {
            sentence: sentence.map(|sentence| Wording::from(sentence).in_units(units)),
            alarms: self.alarms.iter().map(|check| check.clone().in_units(units)).collect(),
            lamps: self.lamps.iter().map(|lamp| lamp.in_units(units)).collect(),
            ..self.clone()
        }
    }
}
