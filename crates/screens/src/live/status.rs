//! How a live string is doing.

use serde::Serialize;
use utoipa::ToSchema;

use super::{checkpoints::CheckpointEntry, lamps::Lamps, pace::Pace};

/// What a live string does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum LiveState {
    /// It waits.
    #[default]
    Paused,
    /// It goes on.
    Running,
    /// It cannot go on from here; it can be taken back to a checkpoint.
    Failed,
    /// It is gone.
    Ended,
}

/// How a live string is doing: sent where something changes, and a few times a second.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct Status {
    /// What it does.
    pub state: LiveState,
    /// Why, where that is to be said; what could not be set, too.
    pub sentence: Option<String>,
    /// Simulated time, s.
    pub time_s: f64,
    /// The pace that is wanted.
    pub pace: Pace,
    /// Simulated seconds in one on the clock, over the last second.
    pub reached: f64,
    /// Moments that it can be taken back to.
    pub checkpoints: Vec<CheckpointEntry>,
    /// How many times something was set.
    pub events: usize,
    /// How many of these are to be done again.
    pub replaying: usize,
    /// Kinetic coefficient of friction of each section of the hole.
    pub friction: Vec<f64>,
    /// The top drive's controller; null where it follows its set point whatever torque that takes.
    pub controller: Option<String>,
    /// Lamps.
    pub lamps: Lamps,
    /// Pages that look at it.
    pub viewers: usize,
}

impl Status {
    /// Of a string that is there and waits.
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
            lamps: Lamps::default(),
            viewers: 0,
        }
    }
}
