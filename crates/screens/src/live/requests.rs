//! Requests about live strings outside their sockets.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_case::{Files, parse};
use wholestring_units::UnitSet;

use super::{
    command::LiveError, live_string::LiveString, recording::RecordedEvent, schedule_text,
    status::LiveState, status::Status,
};
use crate::refusal::Refusal;

impl From<LiveError> for Refusal {
    fn from(error: LiveError) -> Self {
        let message = error.to_string();
        match error {
            LiveError::Nothing(_) => Self::not_found(message),
            LiveError::Refused(_) => Self::bad_input(message),
            LiveError::Ended(_) => Self::new(410, "ended", message),
            LiveError::TooMany(_) => Self::new(429, "too_many", message),
            LiveError::Failed(_) => Self::failed(message),
        }
    }
}

/// A live string to start.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewString {
    /// The id of its case.
    pub case: String,
    /// The text in the editor; that of the file if there is none.
    pub text: Option<String>,
    /// Name of the operation; may be omitted if there is only one.
    pub operation: Option<String>,
}

/// A live string.
#[derive(Debug, Serialize, ToSchema)]
pub struct LiveId {
    /// Identifier in requests.
    pub id: String,
}

/// A live string in a list.
#[derive(Debug, Serialize, ToSchema)]
pub struct LiveEntry {
    /// Identifier in requests.
    id: String,
    /// The id of its case.
    case: String,
    /// The name of the case.
    name: String,
    /// Name of the operation.
    operation: &'static str,
    /// Its state.
    state: LiveState,
    /// Reason of the state, if there is one.
    sentence: Option<String>,
    /// Simulated time, s.
    time_s: f64,
    /// Number of pages that view it.
    viewers: usize,
}

impl LiveEntry {
    /// The entry of a present or former string with this status.
    pub fn of(id: &str, case: &str, name: &str, operation: &'static str, status: &Status) -> Self {
        Self {
            id: id.to_owned(),
            case: case.to_owned(),
            name: name.to_owned(),
            operation,
            state: status.state,
            sentence: status.in_units(UnitSet::Si).sentence,
            time_s: status.time_s,
            viewers: status.viewers,
        }
    }

    /// The entry of a live string.
    pub fn of_string(string: &LiveString) -> Self {
        let layout = &string.layout;
        Self::of(
            &layout.id,
            &layout.case,
            &layout.name,
            layout.operation,
            &string.status().borrow(),
        )
    }
}

/// A checkpoint to rewind to.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Back {
    /// Its number.
    pub checkpoint: u64,
    /// Whether the later set points are applied again, each at its time. Otherwise they are
    /// discarded.
    #[serde(default)]
    pub replay: bool,
}

/// A moment of a string.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct At {
    /// Number of a checkpoint; the present state if there is none.
    pub checkpoint: Option<u64>,
}

/// A text into whose schedule the recorded actions are written.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct TextOfCase {
    /// The text.
    pub text: String,
}

/// A text with the schedule.
#[derive(Debug, Serialize, ToSchema)]
pub struct Scheduled {
    /// The text.
    text: String,
    /// Number of added lines.
    lines: usize,
    /// Actions that no schedule can express, in sentences.
    left_out: Vec<String>,
}

/// Writes the recorded actions into `[[operation.schedule]]` of a text, which is in a file of this
/// name next to these files.
///
/// # Errors
/// A text that is no valid case, before or after the change.
pub fn schedule(
    text: &str,
    events: &[RecordedEvent],
    name: &str,
    files: &dyn Files,
) -> Result<Scheduled, Refusal> {
    let case = parse(name, text.as_bytes(), files, &[])?;
    let made = schedule_text::with_schedule(text, &case, events);
    let made = made.map_err(|error| Refusal::bad_input(error.to_string()))?;
    // The resulting text is a valid case; otherwise the reason is returned.
    parse(name, made.text.as_bytes(), files, &[])?;
    Ok(Scheduled { text: made.text, lines: made.lines, left_out: made.left_out })
}
