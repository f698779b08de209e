//! Start of a live string.

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

/// Limits of the memory of a string.
#[derive(Debug, Clone, Copy)]
pub struct Keeps {
    /// Number of samples for viewers that join later.
    pub samples: usize,
    /// Memory of its checkpoints, bytes.
    pub checkpoint_bytes: usize,
}

/// Input for the start of a string.
pub struct Beginning {
    /// The id of the case.
    pub case_id: String,
    /// The text of the case.
    pub text: String,
    /// The case.
    pub case: Arc<Case>,
    /// The initial state.
    pub start: Start,
}

/// Initial state of a string.
pub enum Start {
    /// Time zero of an operation; the name may be omitted if there is only one.
    New {
        /// Its name.
        operation: Option<String>,
    },
    /// A checkpoint.
    At {
        /// The checkpoint.
        bytes: Arc<Vec<u8>>,
        /// The earlier events.
        events: Vec<RecordedEvent>,
    },
}

/// A simulation, and the state shared with its viewers.
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

/// The controllers available to the drive of a case, with the parameters of the case for its own.
pub(super) fn controllers(case: &Case) -> Vec<(&'static str, SpeedController)> {
    let TopDriveSettings::Driven { controller: own, .. } = case.dynamics.top_drive else {
        return Vec::new();
    };
    let same = |controller: SpeedController| {
        std::mem::discriminant(&controller) == std::mem::discriminant(&own)
    };
    let usual = usual_speed_controllers().into_iter();
    usual.map(|(word, usual)| (word, if same(usual) { own } else { usual })).collect()
}

/// The name of the case's initial controller.
fn own_controller(case: &Case) -> Option<&'static str> {
    let TopDriveSettings::Driven { controller, .. } = case.dynamics.top_drive else { return None };
    controllers(case).into_iter().find(|(_, other)| *other == controller).map(|(word, _)| word)
}

/// The name of the controller after these events.
pub(super) fn last_controller(case: &Case, events: &[RecordedEvent]) -> Option<&'static str> {
    let last = events.iter().rev().find_map(|event| event.set.controller.as_deref());
    let known = controllers(case).into_iter();
    let found = known.map(|(word, _)| word).find(|word| Some(*word) == last);
    found.or_else(|| own_controller(case))
}
