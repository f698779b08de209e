//! Saved strings, to be continued.

use std::io;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::{command::LiveError, live_string::LiveString, recording::RecordedEvent};

/// First bytes of a saved string.
const MARK: &[u8; 8] = b"WSLIVE1\n";

/// Data saved with the checkpoint.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Head {
    case_id: String,
    name: String,
    operation: String,
    time_s: f64,
    text: String,
    events: Vec<RecordedEvent>,
}

/// A saved string.
#[derive(Debug, Clone)]
pub struct KeptString {
    /// The id of its case.
    pub case_id: String,
    /// The name of the case.
    pub name: String,
    /// Name of the operation.
    pub operation: String,
    /// Its time, s.
    pub time_s: f64,
    /// The text of the case.
    pub text: String,
    /// The events.
    pub events: Vec<RecordedEvent>,
    /// The checkpoint.
    pub checkpoint: Vec<u8>,
}

/// A saved string in a list.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct KeptEntry {
    /// Identifier in requests.
    pub name: String,
    /// The id of its case.
    pub case: String,
    /// The name of the case.
    pub title: String,
    /// Name of the operation.
    pub operation: String,
    /// Its time, s.
    pub time_s: f64,
    /// Time when it was saved, milliseconds since 1970.
    pub modified_ms: u64,
}

impl KeptString {
    /// The bytes of its file.
    ///
    /// # Errors
    /// None for a valid string.
    pub fn bytes(&self) -> io::Result<Vec<u8>> {
        let Self { case_id, name, operation, time_s, text, events, checkpoint } = self.clone();
        let head = Head { case_id, name, operation, time_s, text, events };
        let head = serde_json::to_vec(&head)?;
        let length = u32::try_from(head.len()).map_err(io::Error::other)?;
        let mut bytes = MARK.to_vec();
        bytes.extend(length.to_le_bytes());
        bytes.extend(head);
        bytes.extend(checkpoint);
        Ok(bytes)
    }

    /// Reads the bytes of a file; none if it is not such a file.
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        let rest = bytes.strip_prefix(MARK)?;
        let (length, rest) = rest.split_first_chunk::<4>()?;
        let (head, checkpoint) = rest.split_at_checked(u32::from_le_bytes(*length) as usize)?;
        let Head { case_id, name, operation, time_s, text, events } =
            serde_json::from_slice(head).ok()?;
        let checkpoint = checkpoint.to_vec();
        Some(Self { case_id, name, operation, time_s, text, events, checkpoint })
    }
}

impl LiveString {
    /// The string to be saved, without its checkpoint.
    pub fn as_kept(&self) -> KeptString {
        KeptString {
            case_id: self.layout.case.clone(),
            name: self.layout.name.clone(),
            operation: self.layout.operation.to_owned(),
            time_s: self.status().borrow().time_s,
            text: self.text.clone(),
            events: self.events(),
            checkpoint: Vec::new(),
        }
    }

    /// The string to be saved, at a checkpoint or now.
    ///
    /// # Errors
    /// The string has ended, or the checkpoint is unknown.
    pub async fn kept_at(&self, checkpoint: Option<u64>) -> Result<KeptString, LiveError> {
        let moment = self.moment(checkpoint).await?;
        Ok(KeptString {
            time_s: moment.time_s,
            events: moment.events,
            checkpoint: moment.bytes.to_vec(),
            ..self.as_kept()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_read_back_and_damage_is_none() {
        let string = KeptString {
            case_id: "0".into(),
            name: "slant".into(),
            operation: "drill".into(),
            time_s: 12.5,
            text: "a = 1\n".into(),
            events: Vec::new(),
            checkpoint: vec![1, 2, 3],
        };
        let bytes = string.bytes().expect("bytes");
        let back = KeptString::of_bytes(&bytes).expect("a kept string");
        assert_eq!((back.time_s, back.text.as_str()), (12.5, "a = 1\n"));
        assert_eq!(back.checkpoint, [1, 2, 3]);
        for end in 0..bytes.len() - 3 {
            assert!(KeptString::of_bytes(&bytes[..end]).is_none(), "{end}");
        }
    }
}
