//! How a string comes to be live.

use std::sync::Arc;

use wholestring::dynamics::{SpeedController, TopDriveSettings};
use wholestring_case::{Case, usual_speed_controllers};
use wholestring_runner::{
    CancellationToken, Error, Silent,
    run::{Live, OwnLaws},
};

use super::{
    command::LiveError,
    layout::Layout,
    live_string::{LiveString, Parts},
    pace::Pace,
    recording::RecordedEvent,
};

/// How much is kept of a string.
#[derive(Debug, Clone, Copy)]
pub struct Keeps {
    /// Samples, for who comes late.
    pub samples: usize,
    /// Memory of its checkpoints, bytes.
    pub checkpoint_bytes: usize,
}

/// What a string is begun with.
pub struct Beginning {
    /// The id of the case.
    pub case_id: String,
    /// The text that the case was made of.
    pub text: String,
    /// The case.
    pub case: Arc<Case>,
    /// Where it begins.
    pub start: Start,
}

/// Where a string begins.
pub enum Start {
    /// At time zero of an operation; of the only one where none is named.
    New {
        /// Its name.
        operation: Option<String>,
    },
    /// At a checkpoint.
    At {
        /// The checkpoint.
        bytes: Arc<Vec<u8>>,
        /// What was set before.
        events: Vec<RecordedEvent>,
    },
}

/// A simulation, and what its viewers share.
pub(super) struct Begun {
    pub(super) live: Live,
    pub(super) string: Arc<LiveString>,
}

pub(super) fn refused(error: Error) -> LiveError {
    match error {
        Error::BadInput(message) => LiveError::Refused(message),
        error => LiveError::Failed(error.to_string()),
    }
}

/// Initialises a string, which takes a second or more.
pub(super) fn begin(id: &str, from: Beginning, keeps: &Keeps) -> Result<Begun, LiveError> {
    let Beginning { case_id, text, case, start } = from;
    let laws = OwnLaws::default();
    let (live, events) = match start {
        Start::New { operation } => {
            let none = CancellationToken::new();
            let begun =
                Live::begin(case.clone(), operation.as_deref(), &laws, None, &Silent, &none);
            (begun.map_err(refused)?, Vec::new())
        }
        Start::At { bytes, events } => {
            (Live::resume(case.clone(), &laws, None, &bytes).map_err(refused)?, events)
        }
    };
    let (operation, simulation) = (*live.operation(), live.simulation());
    let layout = Layout::of(id, &case_id, &case, &operation, simulation, keeps.samples);
    let string = LiveString::new(Parts {
        layout,
        operation,
        text,
        events,
        checkpoint_bytes: keeps.checkpoint_bytes,
        time_s: simulation.time_s(),
        pace: Pace::Times(1.0),
        case,
    });
    Ok(Begun { live, string: Arc::new(string) })
}

/// The controllers that the drive of a case can have: the case's own with its numbers.
pub(super) fn controllers(case: &Case) -> Vec<(&'static str, SpeedController)> {
    let TopDriveSettings::Driven { controller: own, .. } = case.dynamics.top_drive else {
        return Vec::new();
    };
    let same = |of: SpeedController| std::mem::discriminant(&of) == std::mem::discriminant(&own);
    let usual = usual_speed_controllers().into_iter();
    usual.map(|(word, of)| (word, if same(of) { own } else { of })).collect()
}

/// The word of the controller that a case begins with.
fn own_controller(case: &Case) -> Option<&'static str> {
    let TopDriveSettings::Driven { controller, .. } = case.dynamics.top_drive else { return None };
    controllers(case).into_iter().find(|(_, of)| *of == controller).map(|(word, _)| word)
}

/// The word of the controller that a case has after what was set.
pub(super) fn last_controller(case: &Case, events: &[RecordedEvent]) -> Option<&'static str> {
    let last = events.iter().rev().find_map(|of| of.set.controller.as_deref());
    let known = controllers(case).into_iter();
    let found = known.map(|(word, _)| word).find(|word| Some(*word) == last);
    found.or_else(|| own_controller(case))
}
