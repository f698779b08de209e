//! What is asked of live strings beside their sockets.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_case::{Files, parse};

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

/// A string that is to be live.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewString {
    /// The id of its case.
    pub case: String,
    /// The text, as it stands in the editor; that of the file where there is none.
    pub text: Option<String>,
    /// Name of the operation; the only one where none is named.
    pub operation: Option<String>,
}

/// A string that is live.
#[derive(Debug, Serialize, ToSchema)]
pub struct LiveId {
    /// What requests call it.
    pub id: String,
}

/// A live string in a list.
#[derive(Debug, Serialize, ToSchema)]
pub struct LiveEntry {
    /// What requests call it.
    id: String,
    /// The id of its case.
    case: String,
    /// What the case calls itself.
    name: String,
    /// Name of the operation.
    operation: &'static str,
    /// What it does.
    state: LiveState,
    /// Why, where that is to be said.
    sentence: Option<String>,
    /// Simulated time, s.
    time_s: f64,
    /// Pages that look at it.
    viewers: usize,
}

impl LiveEntry {
    /// Of a string that is, or was, as this status says.
    pub fn of(id: &str, case: &str, name: &str, operation: &'static str, status: &Status) -> Self {
        Self {
            id: id.to_owned(),
            case: case.to_owned(),
            name: name.to_owned(),
            operation,
            state: status.state,
            sentence: status.sentence.clone(),
            time_s: status.time_s,
            viewers: status.viewers,
        }
    }

    /// Of a string that is live.
    pub fn of_string(string: &LiveString) -> Self {
        let of = &string.layout;
        Self::of(&of.id, &of.case, &of.name, of.operation, &string.status().borrow())
    }
}

/// A checkpoint that a string is to be taken back to.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Back {
    /// Its number.
    pub checkpoint: u64,
    /// Whether what was set after it is set again, each at its time. It is forgotten otherwise.
    #[serde(default)]
    pub replay: bool,
}

/// A moment of a string.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct At {
    /// Number of a checkpoint; now where there is none.
    pub checkpoint: Option<u64>,
}

/// A text that is to have what was done in its schedule.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct TextOfCase {
    /// The text.
    pub text: String,
}

/// A text that has the schedule.
#[derive(Debug, Serialize, ToSchema)]
pub struct Scheduled {
    /// The text.
    text: String,
    /// Lines that were added.
    lines: usize,
    /// What no schedule can say, in sentences.
    left_out: Vec<String>,
}

/// Writes what was done into `[[operation.schedule]]` of a text, which is in a file of this name
/// beside these files.
///
/// # Errors
/// A text that is no valid case, before or after it.
pub fn schedule(
    text: &str,
    events: &[RecordedEvent],
    name: &str,
    files: &dyn Files,
) -> Result<Scheduled, Refusal> {
    let case = parse(name, text.as_bytes(), files, &[])?;
    let made = schedule_text::with_schedule(text, &case, events);
    let made = made.map_err(|error| Refusal::bad_input(error.to_string()))?;
    // What comes out is a valid case, or it is said why not.
    parse(name, made.text.as_bytes(), files, &[])?;
    Ok(Scheduled { text: made.text, lines: made.lines, left_out: made.left_out })
}
